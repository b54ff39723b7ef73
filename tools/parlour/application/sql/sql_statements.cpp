// Collects the statements of <querydb> and of topics' queries. Positions inside
// of a statement are kept, so that the database's complaint can be shown at the
// right word.

#include "tools/parlour/application/sql/sql_statements.hpp"

#include <algorithm>
#include <iterator>

#include "script/compiler/code/expressions/expression_compiler.hpp"
#include "script/lint/lint_context.hpp"

namespace parlour::tools {

namespace {

using script::Attribute;
using script::Element;
using script::ExpressionCompiler;
using script::NodeKind;
using script::parse_expression;

// Replaces each {expr} by a placeholder, as when the statement runs.
// `embeds`: whether the attribute has values in braces; a topic's <query> has
// none.
SqlStatement statement_of(const Attribute& attribute, bool embeds) {
  SqlStatement statement{{}, {}, attribute.value_position};
  if (!embeds) {
    statement.pieces.emplace_back(0, 0);
    statement.sql = attribute.value;
    return statement;
  }
  std::size_t at = 0; // in the value
  for (const auto& part : ExpressionCompiler::split_text(
           {attribute.value, attribute.value_position})) {
    if (part.node) {
      at = part.source.skip + part.source.text.size() + 1;
      statement.sql += '?';
      continue;
    }
    statement.pieces.emplace_back(statement.sql.size(), at);
    statement.sql += part.literal;
  }
  return statement;
}

// Whether the statement is literal: a text, or a single quoted string.
bool is_written_out(const Attribute& attribute) {
  const auto parsed = parse_expression(attribute.value);
  return !parsed.node || parsed.node->kind == NodeKind::string;
}

// A text with embedded values, or a quoted text; with `db` it is for another
// database.
void add_querydb(const Element& element, std::vector<SqlStatement>& all) {
  const auto* param = element.attribute("param");
  if (!param || element.attribute("db") || !is_written_out(*param))
    return;
  const auto parsed = parse_expression(param->value);
  if (!parsed.node)
    return all.push_back(statement_of(*param, true));
  SqlStatement statement{
      parsed.node->text, {{0, parsed.node->offset + 1}}, param->value_position};
  all.push_back(std::move(statement));
}

// A topic's <query>, with the columns of its <by> elements.
void add_query(const Element& element, std::vector<SqlStatement>& all) {
  const auto* param = element.attribute("param");
  if (!param || element.value("source") != "db")
    return;
  auto statement = statement_of(*param, false);
  for (const auto& by : element.children) {
    const auto* column =
        by.attribute(by.attribute("column") ? "column" : "slot");
    if (by.is("by") && column)
      statement.columns.emplace_back(column->value, column->value_position);
  }
  all.push_back(std::move(statement));
}

} // namespace

// The last piece that begins at or before the offset contains it.
script::Spot SqlStatement::spot(std::size_t offset, std::size_t length) const {
  script::Spot spot{start};
  for (const auto& [from, at] : pieces)
    if (from <= offset)
      spot.skip = at + offset - from;
  spot.length = length;
  return spot;
}

// After a <connectdb> without a name it is not known which database a <querydb>
// asks.
std::vector<SqlStatement> sql_statements(const script::Compiled& compiled) {
  std::vector<SqlStatement> of_topics; // always of the application's database
  std::vector<SqlStatement> of_scripts;
  bool connects = false;
  const script::lint::Options options;
  const script::lint::LintContext context{*compiled.program, compiled.documents,
                                          nullptr, options};
  script::lint::walk(
      context, false,
      [&](const Element& element, const script::ElementRule& rule) {
        connects |= element.is("connectdb") && !element.attribute("name");
        if (element.is("querydb") && script::lint::is_statement(rule))
          add_querydb(element, of_scripts);
        else if (element.is("query"))
          add_query(element, of_topics);
      });
  if (!connects)
    std::ranges::move(of_scripts, std::back_inserter(of_topics));
  return of_topics;
}

} // namespace parlour::tools
