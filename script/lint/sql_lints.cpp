// joined-sql, if the statement is built in a variable first. The compiler
// reports what is built in the <querydb> itself.
//
//   <var name="q" expr="'select * from staff where id=' + id"/>
//   <querydb param="q"/>
#include <algorithm>
#include <array>
#include <map>

#include "runtime/text/sql_scanner.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Whether the text begins with a word of SQL, in any case.
bool begins_like_sql(const std::string& text) {
  static constexpr std::array<std::string_view, 5> words{
      "select", "insert", "update", "delete", "with"};
  return std::ranges::count(words, first_sql_word(text)) > 0;
}

// The first operand of a chain of operators.
const Node& leftmost(const Node& node) {
  return node.kind == NodeKind::binary ? leftmost(*node.children[0]) : node;
}

// Whether the expression has the form 'select …' + x.
bool is_joined_sql(const std::string& expression) {
  const auto parsed = parse_expression(expression);
  if (!parsed.node || parsed.node->kind != NodeKind::binary ||
      parsed.node->operation != Operator::add)
    return false;
  const auto& first = leftmost(*parsed.node);
  return first.kind == NodeKind::string && begins_like_sql(first.text);
}

// Remembers variables with joined statements until a <querydb> uses one.
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

void lint_joined_sql(const LintContext& context, Findings& findings) {
  if (context.program.settings.unsafe_sql)
    return;
  for (const auto& document : context.documents)
    for (const auto& child : document.root.children)
      if (const auto* rule =
              find_rule(child.name, rule_of(document.root).holds);
          rule && !document.platform)
        lint_body(child, *rule, findings);
}

} // namespace parlour::script::lint
