// Variables and containers (language rule 5).
#include "script/compiler/code/statements.hpp"

namespace parlour::script {

void StatementCompiler::initial(const Element& element, Register target) {
  if (const auto* expression = element.attribute("expr"))
    expressions_.expression(source_of(*expression), target);
  else
    b_.load(target, Box());
}

// Declares in the enclosing block; again in the same block: assigns.
void StatementCompiler::define(const Element& element, bool is_constant) {
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
  const auto value = b_.allocate(); // the initial value sees an outer variable
  initial(element, value);
  b_.release(value);
  b_.declare(name->value, is_constant);
}

void StatementCompiler::declare_variable(const Element& element) {
  define(element, false);
}

void StatementCompiler::declare_constant(const Element& element) {
  define(element, true);
}

void StatementCompiler::set(const Element& element) {
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
  // A plain local takes its value without a detour.
  if (meaning.local && !meaning.local->is_parameter &&
      !meaning.local->is_constant)
    return initial(element, meaning.local->reg);
  const auto value = b_.allocate();
  initial(element, value);
  if (!expressions_.assign(*target, source, value))
    error(source.start, "'" + name->value + "' cannot be set");
  b_.release(mark);
}

void StatementCompiler::object(const Element& element) {
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

void StatementCompiler::get_list(const Element& element) {
  const auto value = b_.allocate();
  b_.emit(Operation::load_message_parameters, value);
  store_result(required(element, "name"), value);
}

void StatementCompiler::append(const Element& element) {
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
    if (is_this_field(*target)) // a slot's value is a copy
      expressions_.assign(*target, source, list);
  }
  b_.release(mark);
}

} // namespace parlour::script
