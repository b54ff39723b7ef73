// CodeBuilder: a Code under construction: its instructions and registers, and
// the names that are visible at the current place. The compilers of expressions
// and statements share one.
//
// Registers are allocated like a stack: a block's locals stay until it closes,
// and temporaries lie above them and are released by going back to a mark. So
// there is no separate pass for register allocation, and a body needs as many
// registers as it has values at its deepest point.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "script/compiler/code/expressions/declared_names.hpp"
#include "script/expression/expression.hpp"
#include "script/expression/expression_mistakes.hpp"
#include "script/program/host.hpp"
#include "script/program/instruction.hpp"
#include "script/source/findings.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

using Register = std::uint16_t;
using Label = std::size_t; // the index of a jump without a target

// A name for a register in the current scopes.
struct Local {
  std::string name;
  Register reg = 0;
  bool is_parameter = false; // may be bound to a variable
  bool is_constant = false;
};

// What a name means at the place where it occurs. Inner names hide outer ones
// in the order of the kinds below.
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

// A text and where it begins in the file, so that a mistake inside of it can be
// reported at its exact place.
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
  // The place for a finding, which is exact.
  Spot spot(std::size_t offset = 0, std::size_t length = 0) const {
    return {value.line > 0 ? value : start, skip + offset, length, collapsed};
  }
};

// The value of an attribute as a Source.
Source source_of(const Attribute& attribute);

// One builder makes one Code; finish() ends its life.
class CodeBuilder {
public:
  CodeBuilder(Program& shared_program, const Names& all_names,
              Findings& all_findings, BodyContext body_context);

  Program& program;
  const Names& names;
  Findings& findings;
  BodyContext context;
  Code code;

  // -- instructions: each gets the position set last --------------------------
  void at(Position position) {
    position_ = position;
  }
  Position position() const {
    return position_;
  }
  // emit() returns the index of the instruction, which is the label of a jump
  // whose target is set later.
  Label emit(Operation operation, std::size_t a = 0, std::size_t b = 0,
             std::size_t c = 0, std::uint8_t flag = 0);
  Label emit_wide(Operation operation, std::size_t a, std::uint32_t wide,
                  std::uint8_t flag = 0);
  std::uint32_t here() const {
    return static_cast<std::uint32_t>(code.instructions.size());
  }
  void land(Label label); // the jump goes to here
  void land(const std::vector<Label>& labels);
  // Emits a jump back to an earlier instruction.
  void back(Operation operation, std::size_t a, std::uint32_t target);
  // Sets the target of a jump. Compare-and-jump instructions have only 16 bits
  // for the distance; a body for which that is too little is reported as too
  // long.
  void exits_to(Label label, std::uint32_t target);

  // Adds a constant of the code, or returns the one that is equal.
  std::uint16_t constant(Box box);
  std::uint16_t text_constant(std::string_view text);
  void load(Register target, Box constant_value);
  // Declares a name that was declared elsewhere, so it is not checked again.
  Register adopt(std::string_view name, bool is_constant);
  // Gives a register another, constant name until the scope closes.
  void alias(std::string_view name, Register target);
  void declare_parameter(std::string_view name, Register target);
  // Loads a text that the program's pool of constants keeps.
  void load_text(Register target, std::string_view text);
  // Adds the shape of an effect and returns its index.
  std::uint16_t shape(EffectShape shape);
  // The instruction emitted since `from`, if it is only one and of this kind;
  // otherwise null. With take_back() this recognises simple cases after they
  // were compiled, such as an operand that is just a constant.
  Instruction* only(std::uint32_t from, Operation operation);
  // Removes that instruction.
  Instruction take_back();

  // -- registers --------------------------------------------------------------

  // Takes consecutive registers; release() goes back to a mark.
  Register allocate(std::size_t count = 1);
  Register mark() const {
    return next_;
  }
  void release(Register mark) {
    next_ = mark;
  }
  // Whether this is the register allocated last and no name stands for it, so
  // that its value may be overwritten early.
  bool is_last_temporary(Register reg) const;

  // -- names ------------------------------------------------------------------

  // A block: its names and registers end with it.
  void open_scope();
  void close_scope();
  // The local of this name in the innermost block; null if there is none.
  Local* in_block(std::string_view name);
  Register declare(std::string_view name, bool is_constant = false);
  // Looks the name up: locals from the innermost, session variables, system
  // variables, parameters of the message.
  Meaning find(std::string_view name) const;
  const FunctionName* function(std::string_view name) const;
  // Candidates for "did you mean".
  std::vector<std::string> visible_names() const;
  std::vector<std::string> function_names() const;
  const std::vector<Local>& locals() const {
    return locals_;
  }

  Code finish(); // adds a final give_unknown

private:
  void check_name(std::string_view name);

  Position position_;
  Register next_ = 0;
  bool too_large_ = false;
  std::vector<Local> locals_;
  std::vector<std::pair<std::size_t, Register>> scopes_;
};

// The number of `_LPARAM3`, counted from 0; nothing for another name.
std::optional<std::uint32_t> message_parameter(std::string_view name);
std::optional<SystemVariable> system_variable(std::string_view name);

} // namespace parlour::script
