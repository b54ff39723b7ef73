#include "script/compiler/code/statements/statement_group.hpp"

namespace parlour::script {

const Attribute* StatementGroup::required(const Element& element,
                                          const char* name) {
  const auto* attribute = element.attribute(name);
  if (!attribute)
    error(element.position,
          "<" + element.name + "> needs the attribute '" + name + "'");
  return attribute;
}

// A new variable takes over the register of the value.
void StatementGroup::store_result(const Attribute* attribute, Register from) {
  if (!attribute)
    return b_.release(from);
  const auto source = source_of(*attribute);
  auto parsed = parse_expression(source.text);
  const bool is_new = parsed.node && parsed.node->kind == NodeKind::name &&
                      parsed.node->text != "this" &&
                      b_.find(parsed.node->text).kind == Meaning::Kind::nothing;
  if (!is_new &&
      (!parsed.node || !expressions_.assign(*parsed.node, source, from)))
    error(source.start, "'" + attribute->value + "' is not a variable");
  b_.release(from);
  if (is_new)
    b_.declare(parsed.node->text); // gets the register `from`
}

// The value of `expr`; unknown without it.
void StatementGroup::initial(const Element& element, Register target) {
  if (const auto* expression = element.attribute("expr"))
    expressions_.expression(source_of(*expression), target);
  else
    b_.load(target, Box());
}

// Marks the beginning of a branch for coverage.
void StatementGroup::reached(const Element& element) {
  b_.at(element.position);
  b_.emit(Operation::reached);
}

// Compiles the condition of an <if> or <while>. Returns the jumps that are
// taken if it does not hold; they are landed where the next part begins:
//
//       jump_if_less_constant x < 3 is false -> next
//       …                         the part
//   next:
std::vector<Label> StatementGroup::condition(const Element& element,
                                             const char* attribute) {
  std::vector<Label> otherwise;
  const auto* condition = required(element, attribute);
  if (!condition)
    return otherwise;
  const auto source = source_of(*condition);
  if (const auto node = expressions_.parse(source))
    expressions_.jump(*node, source, false, otherwise);
  return otherwise;
}

} // namespace parlour::script
