#include "script/lint/sql_statements.hpp"

#include "script/compiler/code/expression_compiler.hpp"
#include "script/lint/subject.hpp"

namespace parlour::script::lint {

namespace {

// Each {expr} becomes a placeholder, as when it runs.
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

// A statement that is written out: text, or one quoted text.
bool is_written_out(const Attribute& attribute) {
  const auto parsed = parse_expression(attribute.value);
  return !parsed.node || parsed.node->kind == NodeKind::string;
}

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

Spot SqlStatement::spot(std::size_t offset, std::size_t length) const {
  Spot spot{start};
  for (const auto& [from, at] : pieces)
    if (from <= offset)
      spot.skip = at + offset - from;
  spot.length = length;
  return spot;
}

std::vector<SqlStatement> sql_statements(const Compiled& compiled) {
  std::vector<SqlStatement> all;
  bool connects = false;
  const Options options;
  const Subject subject{*compiled.program, compiled.documents, nullptr,
                        options};
  walk(subject, false, [&](const Element& element, const ElementRule& rule) {
    connects |= element.is("connectdb") && !element.attribute("name");
    if (element.is("querydb") && is_statement(rule))
      add_querydb(element, all);
    else if (element.is("query"))
      add_query(element, all);
  });
  if (connects) // then only a topic's queries are sure to be of this database
    std::erase_if(all,
                  [](const SqlStatement& one) { return one.columns.empty(); });
  return all;
}

} // namespace parlour::script::lint
