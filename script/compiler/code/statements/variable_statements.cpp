// Variables and containers (language rule 5).
#include "script/compiler/code/statements/variable_statements.hpp"

namespace parlour::script {

// Declares a variable in the enclosing block, or assigns it if the block has it
// already (language rule 5.2).
void VariableStatements::define(const Element& element, bool is_constant) {
  const auto* name = required(element, "name");
  if (!name)
    return;
  const auto meaning = b_.find(name->value);
  if (meaning.local && meaning.local->is_parameter)
    error(name->value_position,
          "'" + name->value + "' is a parameter; <set> assigns it");
  if (auto* there = b_.in_block(name->value)) {
    if (there->is_constant || is_constant)
      error(name->value_position, "'" + name->value + "' is a constant");
    return initial(element, there->reg);
  }
  const auto value = b_.allocate(); // it may read an outer variable
  initial(element, value);
  b_.release(value);
  b_.declare(name->value, is_constant);
}

void VariableStatements::declare_variable(const Element& element) {
  define(element, false);
}

void VariableStatements::declare_constant(const Element& element) {
  define(element, true);
}

// Assigns a variable, an element, a field or a slot (language rule 5.5).
void VariableStatements::set(const Element& element) {
  const auto* name = required(element, "name");
  if (!name)
    return;
  auto source = source_of(*name);
  source.wanted = Wanted::target;
  const auto target = expressions_.parse(source);
  if (!target)
    return;
  const auto mark = b_.mark();
  const auto meaning =
      target->kind == NodeKind::name ? b_.find(target->text) : Meaning{};
  // A plain local variable is computed in place.
  if (meaning.local && !meaning.local->is_parameter &&
      !meaning.local->is_constant)
    return initial(element, meaning.local->reg);
  const auto value = b_.allocate();
  initial(element, value);
  if (!expressions_.assign(*target, source, value))
    error(source.start, "'" + name->value + "' cannot be set");
  b_.release(mark);
}

// <object>: an empty list or map, or a list of unknowns (language rule 5.7).
void VariableStatements::object(const Element& element) {
  const auto* name = required(element, "name");
  const auto* kind = required(element, "class");
  if (!name || !kind)
    return;
  auto* there = b_.in_block(name->value);
  const auto target = there ? there->reg : b_.allocate();
  const auto temporary = b_.mark();
  if (kind->value == "map") {
    b_.emit(Operation::new_map, target);
  } else if (kind->value == "array") {
    const auto size = b_.allocate();
    if (const auto* attribute = required(element, "size"))
      expressions_.expression(source_of(*attribute), size);
    b_.emit(Operation::new_array, target, size);
  } else {
    if (kind->value != "list")
      error(kind->value_position,
            "a class is list, array or map, not '" + kind->value + "'");
    b_.emit(Operation::new_list, target);
  }
  b_.release(temporary);
  if (there)
    return;
  b_.release(target);
  b_.declare(name->value);
}

// <getlist>: all parameters of the message being handled (language rule 5.9).
void VariableStatements::get_list(const Element& element) {
  const auto value = b_.allocate();
  b_.emit(Operation::load_message_parameters, value);
  store_result(required(element, "name"), value);
}

// <append>. A list in a variable is changed in place, as lists are shared
// (language rule 2.6); a slot gives a copy of its value, which must be stored
// back.
void VariableStatements::append(const Element& element) {
  const auto* name = required(element, "name");
  const auto* expression = required(element, "expr");
  if (!name || !expression)
    return;
  const auto mark = b_.mark();
  const auto source = source_of(*name);
  if (const auto target = expressions_.parse(source)) {
    const auto list = expressions_.any(*target, source);
    const auto value = b_.allocate();
    expressions_.expression(source_of(*expression), value);
    b_.emit(Operation::append, list, value);
    if (is_this_field(*target)) // a slot gives a copy
      expressions_.assign(*target, source, list);
  }
  b_.release(mark);
}

} // namespace parlour::script
