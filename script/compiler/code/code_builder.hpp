// CodeBuilder: one Code under construction: instructions, registers, the
// names that are visible. Used by the expression and statement compilers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "script/compiler/code/declared_names.hpp"
#include "script/expression/expression.hpp"
#include "script/expression/expression_slips.hpp"
#include "script/program/host.hpp"
#include "script/program/instruction.hpp"
#include "script/source/findings.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

using Register = std::uint16_t;
using Label = std::size_t; // an instruction whose jump is still open

struct Local {
  std::string name;
  Register reg = 0;
  bool is_parameter = false; // may be bound to a variable
  bool is_constant = false;
};

// What a name means where it stands.
struct Meaning {
  enum class Kind : std::uint8_t {
    nothing,
    local,
    variable,  // of the session: index
    system,    // index: SystemVariable
    parameter, // of the message: index
  };
  Kind kind = Kind::nothing;
  const Local* local = nullptr;
  std::uint32_t index = 0;
};

// A text and where it begins, to place what stands inside of it.
struct Source {
  std::string_view text;
  Position start;         // for instructions; entities before it count as one
  bool collapsed = false; // the text went through script::collapsed
  Position value{};       // where the whole value begins; line 0: at `start`
  std::size_t skip = 0;   // bytes of the value before the text
  Wanted wanted = Wanted::value;

  Position at(std::size_t offset) const;
  Source part(std::size_t offset, std::size_t length) const {
    return {text.substr(offset, length),    at(offset),    collapsed,
            value.line > 0 ? value : start, skip + offset, Wanted::value};
  }
  // For findings: exact.
  Spot spot(std::size_t offset = 0, std::size_t length = 0) const {
    return {value.line > 0 ? value : start, skip + offset, length, collapsed};
  }
};

// The value of an attribute.
Source source_of(const Attribute& attribute);

class CodeBuilder {
public:
  CodeBuilder(Program& shared_program, const Names& all_names,
              Findings& all_findings, BodyContext body_context);

  Program& program;
  const Names& names;
  Findings& findings;
  BodyContext context;
  Code code;

  // -- instructions; all get the position set last ----------------------------
  void at(Position position) {
    position_ = position;
  }
  Position position() const {
    return position_;
  }
  Label emit(Operation operation, std::size_t a = 0, std::size_t b = 0,
             std::size_t c = 0, std::uint8_t flag = 0);
  Label emit_wide(Operation operation, std::size_t a, std::uint32_t wide,
                  std::uint8_t flag = 0);
  std::uint32_t here() const {
    return static_cast<std::uint32_t>(code.instructions.size());
  }
  void land(Label label); // it jumps to here
  void land(const std::vector<Label>& labels);
  void back(Operation operation, std::size_t a, std::uint32_t target);
  void exits_to(Label label, std::uint32_t target);

  std::uint16_t constant(Box box);
  std::uint16_t text_constant(std::string_view text);
  void load(Register target, Box constant_value);
  // A parameter in a register that is allocated.
  // One that was declared elsewhere: its name is not judged again.
  Register adopt(std::string_view name, bool is_constant);
  // A further, constant name of a register, until the scope closes.
  void alias(std::string_view name, Register target);
  void declare_parameter(std::string_view name, Register target);
  void load_text(Register target, std::string_view text);
  std::uint16_t shape(EffectShape shape);
  // What was emitted since `from`, where it is a single instruction of this
  // kind; else null.
  Instruction* only(std::uint32_t from, Operation operation);
  // Takes that instruction back.
  Instruction take_back();

  // -- registers --------------------------------------------------------------
  Register allocate(std::size_t count = 1);
  Register mark() const {
    return next_;
  }
  void release(Register mark) {
    next_ = mark;
  }
  // The last register allocated, with nothing in it that a name stands for.
  bool is_last_temporary(Register reg) const;

  // -- names ------------------------------------------------------------------
  void open_scope();
  void close_scope();
  // Null where it is not in the innermost block.
  Local* in_block(std::string_view name);
  Register declare(std::string_view name, bool is_constant = false,
                   bool is_parameter = false);
  Meaning find(std::string_view name) const;
  const FunctionName* function(std::string_view name) const;
  std::vector<std::string> visible_names() const;
  std::vector<std::string> function_names() const;
  const std::vector<Local>& locals() const {
    return locals_;
  }

  Code finish(); // adds the final give_unknown

private:
  void check_name(std::string_view name);

  Position position_;
  Register next_ = 0;
  bool too_large_ = false;
  std::vector<Local> locals_;
  std::vector<std::pair<std::size_t, Register>> scopes_;
};

// The number of `_LPARAM3`, counted from 0.
std::optional<std::uint32_t> message_parameter(std::string_view name);
std::optional<SystemVariable> system_variable(std::string_view name);

} // namespace parlour::script
