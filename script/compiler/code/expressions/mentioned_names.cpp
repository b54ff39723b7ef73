#include "script/compiler/code/expressions/mentioned_names.hpp"

#include "script/compiler/code/expressions/expression_compiler.hpp"

namespace parlour::script {

namespace {

using Mentioned = std::set<std::string, std::less<>>;

void add(const Node& node, Mentioned& names) {
  if (node.kind == NodeKind::name)
    names.insert(node.text);
  for (const auto& child : node.children)
    add(*child, names);
}

// A value may be expressions or a text with {expressions}; only its element
// knows. Taking it for both finds a name too many at worst.
void add(const Attribute& attribute, Mentioned& names) {
  if (const auto parsed = parse_arguments(attribute.value); parsed.node)
    add(*parsed.node, names);
  for (const auto& part : ExpressionCompiler::split_text(source_of(attribute)))
    if (part.node)
      add(*part.node, names);
}

void add(const Element& element, Mentioned& names) {
  for (const auto& attribute : element.attributes)
    add(attribute, names);
  for (const auto& child : element.children)
    add(child, names);
}

} // namespace

std::set<std::string, std::less<>> mentioned_names(const Element& element) {
  Mentioned names;
  add(element, names);
  return names;
}

} // namespace parlour::script
