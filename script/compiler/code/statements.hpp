// StatementCompiler: the statements of the language, one function each,
// grouped in statements_*.cpp. Which elements and attributes there are was
// checked before, from the element table.
#pragma once

#include <string>
#include <vector>

#include "script/compiler/code/expression_compiler.hpp"
#include "script/compiler/code/table_builder.hpp"
#include "script/source/by_name.hpp"

namespace parlour::script {

// How an effect's operand is written in its element.
enum class OperandForm : std::uint8_t {
  text,     // text with {expr}
  either,   // text or expression
  value,    // expression
  flag,     // true or false
  duration, // "1.5s", becomes milliseconds
  params,   // param, or <param> children; a list, or unknown for none
  state,    // the name of a state, checked unless it has {expr}
  topic,
  handler,
  slot,
  source,     // a component's, not one of the platform's own
  new_source, // a name that messages will come from
};

class StatementCompiler {
public:
  StatementCompiler(CodeBuilder& builder)
      : b_(builder), expressions_(builder) {}

  // The children but those named in `except`, in a block of their own.
  void block(const Element& parent, ElementNames except = {});
  void statements(const Element& parent, ElementNames except);
  void statement(const Element& element);
  // <param> children of a <function>, and where calls begin.
  void parameters(const Element& function);

private:
  using Method = void (StatementCompiler::*)(const Element&);
  static Method find(std::string_view name);

  struct Loop {
    std::vector<Label> breaks;
    std::vector<Label> continues;
    std::size_t transactions = 0; // open ones outside of it
  };

  // statements_values.cpp
  void declare_variable(const Element& element);
  void declare_constant(const Element& element);
  void set(const Element& element);
  void object(const Element& element);
  void get_list(const Element& element);
  void append(const Element& element);
  void initial(const Element& element, Register target);
  void define(const Element& element, bool is_constant);

  // statements_control.cpp
  void if_(const Element& element);
  void switch_(const Element& element);
  void for_(const Element& element);
  void for_each(const Element& element);
  void while_(const Element& element);
  void break_(const Element& element);
  void continue_(const Element& element);
  void confirm(const Element& element);
  void end_loop();
  void reached(const Element& element);
  struct Case {
    const Element* element;
    Label label;
    std::optional<Box> constant; // that the table holds
  };
  struct Switch {
    Register value;
    std::optional<TableBuilder> table;
    std::vector<Case> cases;
  };
  void test(Switch& arms, const Element& element);
  std::optional<Box> compared(std::uint32_t start);
  std::optional<TableBuilder> enter_by_table(std::uint32_t& start,
                                             std::vector<Label>& otherwise);
  std::vector<Label> condition(const Element& element, const char* attribute);

  // statements_calls.cpp
  void call(const Element& element);
  void return_(const Element& element);
  void try_(const Element& element);
  void throw_(const Element& element);
  void catch_errors(std::uint32_t from, const Element* handler);
  struct Argument {
    const Attribute* expression = nullptr;
    Position position;
  };
  std::vector<Argument> call_arguments(const Element& element,
                                       const FunctionName* function);
  void argument(const Argument& argument, Register target, bool may_bind);
  void call_dynamic(const Element& element, const Attribute& function);

  // statements_effects.cpp
  void effect(const Element& element);
  void fire(const Element& element);
  void post(const Element& element);
  void request(const Element& element);
  void timer(const Element& element);
  void transit(const Element& element);
  void params(const Element& element, Register target, bool forwards);
  void operand(const Element& element, const char* attribute, OperandForm form,
               Register target);
  void checked_name(const Attribute& attribute, OperandForm form,
                    Register target);
  void check_source(const Attribute& attribute);
  void check_new_source(const Attribute& attribute);
  void duration(const Attribute& attribute, Register target);
  std::uint32_t meaning(const Attribute* name, OperandForm form) const;
  void perform(EffectKind kind, Register result, Register base,
               std::size_t operands, EffectShape others = {});
  CodeId detached(const Element& element, bool in_timer,
                  std::vector<const Local*>& captured);
  Register capture(const std::vector<const Local*>& captured);

  // statements_data.cpp
  void query(const Element& element);
  void transaction(const Element& element);
  void sql(const Attribute& attribute, const Attribute* args, Register target,
           Register values);
  void bound_sql(const Source& source, std::vector<NodePointer> arguments,
                 const Source& arguments_source, Register target,
                 Register values);
  void joined_sql(const Node& node, const Source& source);
  void impure_sql(std::string_view name, const Source& source);
  void end_transactions(std::size_t outside);

  // -- helpers ----------------------------------------------------------------
  // Puts register `from` into the variable that `return="…"` names, declaring
  // it where it is not visible; null: nowhere. Ends the life of `from` and of
  // the temporary registers behind it.
  void store_result(const Attribute* attribute, Register from);
  const Attribute* required(const Element& element, const char* name);
  void error(Position position, std::string message) {
    b_.findings.error(position, std::move(message));
  }

  CodeBuilder& b_;
  ExpressionCompiler expressions_;
  std::vector<Loop> loops_;
  bool in_case_ = false;
  std::vector<Register> transactions_; // the database's name, of open ones
};

} // namespace parlour::script
