#include "script/compiler/code/statements.hpp"

#include <algorithm>

namespace parlour::script {

StatementCompiler::Method StatementCompiler::find(std::string_view name) {
  using S = StatementCompiler;
  static const ByName<Method> methods{
      {"var", &S::declare_variable},
      {"const", &S::declare_constant},
      {"set", &S::set},
      {"object", &S::object},
      {"getlist", &S::get_list},
      {"append", &S::append},
      {"if", &S::if_},
      {"switch", &S::switch_},
      {"for", &S::for_},
      {"while", &S::while_},
      {"break", &S::break_},
      {"continue", &S::continue_},
      {"call", &S::call},
      {"return", &S::return_},
      {"try", &S::try_},
      {"throw", &S::throw_},
      {"fire", &S::fire},
      {"post", &S::post},
      {"request", &S::request},
      {"timer", &S::timer},
      {"transit", &S::transit},
      {"confirm", &S::confirm},
      {"querydb", &S::query},
      {"transaction", &S::transaction},
  };
  const auto there = methods.find(name);
  return there == methods.end() ? &S::effect : there->second;
}

void StatementCompiler::block(const Element& parent, ElementNames except) {
  b_.open_scope();
  statements(parent, except);
  b_.close_scope();
}

void StatementCompiler::statements(const Element& parent, ElementNames except) {
  for (const auto& child : parent.children)
    if (std::none_of(except.begin(), except.end(),
                     [&](auto name) { return child.is(name); }))
      statement(child);
}

void StatementCompiler::statement(const Element& element) {
  b_.at(element.position);
  (this->*find(element.name))(element);
}

void StatementCompiler::parameters(const Element& function) {
  std::vector<const Element*> all;
  for (const auto& child : function.children)
    if (child.is("param"))
      all.push_back(&child);
  auto& code = b_.code;
  code.parameter_count = static_cast<std::uint16_t>(all.size());
  for (const auto* each : all) {
    const auto* name = each->attribute("name");
    code.required_count = static_cast<std::uint16_t>(code.required_count +
                                                     !each->attribute("expr"));
    code.parameter_names.push_back(name ? name->value : "");
  }
  const auto first = b_.allocate(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& name = code.parameter_names[i];
    const auto target = static_cast<Register>(first + i);
    const auto* initial = all[i]->attribute("expr");
    b_.at(all[i]->position);
    if (b_.in_block(name))
      error(all[i]->position, "a second parameter named '" + name + "'");
    if (initial) {
      const auto given = b_.emit(Operation::jump_if_given, target);
      expressions_.expression(source_of(*initial), target);
      b_.land(given);
    } else if (i > 0 && all[i - 1]->attribute("expr")) {
      error(all[i]->position, "parameters with a default come last");
    }
    b_.declare_parameter(name, target);
  }
  code.body = b_.here();
}

const Attribute* StatementCompiler::required(const Element& element,
                                             const char* name) {
  const auto* attribute = element.attribute(name);
  if (!attribute)
    error(element.position,
          "<" + element.name + "> needs the attribute '" + name + "'");
  return attribute;
}

void StatementCompiler::store_result(const Attribute* attribute,
                                     Register from) {
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
    b_.declare(parsed.node->text); // takes the place of `from`
}

} // namespace parlour::script
