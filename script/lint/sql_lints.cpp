// joined-sql, where the statement is built in a variable first. (What stands
// in <querydb> itself, the compiler tells.)
#include <array>
#include <cctype>
#include <map>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

bool begins_like_sql(const std::string& text) {
  static constexpr std::array<std::string_view, 5> words{
      "select ", "insert ", "update ", "delete ", "with "};
  std::string small;
  for (const char letter : text.substr(0, 12))
    small +=
        static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const auto first = small.find_first_not_of(' ');
  for (const auto word : words)
    if (first != std::string::npos && small.substr(first).starts_with(word))
      return true;
  return false;
}

const Node& leftmost(const Node& node) {
  return node.kind == NodeKind::binary ? leftmost(*node.children[0]) : node;
}

// 'select …' + x, whatever x is.
bool is_joined_sql(const std::string& expression) {
  const auto parsed = parse_expression(expression);
  if (!parsed.node || parsed.node->kind != NodeKind::binary ||
      parsed.node->operation != Operator::add)
    return false;
  const auto& first = leftmost(*parsed.node);
  return first.kind == NodeKind::string && begins_like_sql(first.text);
}

void lint_body(const Element& body, const ElementRule& rule,
               Findings& findings) {
  std::map<std::string, const Attribute*> joined;
  walk(body, rule, [&](const Element& element, const ElementRule& its) {
    if (!is_statement(its))
      return;
    const auto* expression = element.attribute("expr");
    if (expression && (element.is("var") || element.is("set")) &&
        is_joined_sql(expression->value))
      joined[element.value("name")] = expression;
    const auto found = element.is("querydb")
                           ? joined.find(element.value("param"))
                           : joined.end();
    if (found == joined.end())
      return;
    warn(findings, "joined-sql", found->second->value_position,
         "SQL must not be built with '+': write the statement into "
         "<querydb param=\"…\"> with {expr} for each value, so that values "
         "are bound");
    joined.erase(found);
  });
}

} // namespace

void lint_joined_sql(const Subject& subject, Findings& findings) {
  if (subject.program.settings.unsafe_sql)
    return;
  for (const auto& document : subject.documents)
    for (const auto& child : document.root.children)
      if (const auto* rule =
              find_rule(child.name, rule_of(document.root).holds);
          rule && !document.platform)
        lint_body(child, *rule, findings);
}

} // namespace parlour::script::lint
