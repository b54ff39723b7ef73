// Queries of <facts>: a table in the program, read as a database's would be
// (engine rule 6).
#include <algorithm>
#include <compare>
#include <numeric>
#include <utility>

#include "runtime/text/sql_check.hpp"
#include "script/dialogue/frame/spelling.hpp"
#include "script/dialogue/knowledge/knowledge_query.hpp"

namespace parlour::dialogue {

namespace {

using script::Match;

struct Condition {
  std::string column;
  Match match = Match::equal;
  Value value;
};

// Texts as they are heard: case, punctuation and spaces aside.
bool equal(const Value& cell, const Value& value) {
  if (cell.if_string() && value.if_string())
    return folded(*cell.if_string()) == folded(*value.if_string());
  return cell == value;
}

// An empty cell fits nothing, as null does in SQL.
bool holds(const Condition& condition, const Value& cell) {
  if (cell.is_unknown())
    return false;
  if (condition.match == Match::equal)
    return equal(cell, condition.value);
  const auto at = folded(cell.text()).find(folded(condition.value.text()));
  return condition.match == Match::prefix ? at == 0 : at != std::string::npos;
}

std::vector<Condition> conditions_of(const script::Topic& topic,
                                     const script::KnowledgeSource& source,
                                     const Statement& statement) {
  std::vector<Condition> conditions;
  for (const auto& by : source.by) {
    const auto& slot = topic.slots[by.slot];
    const auto& value = statement.asked[slot.name];
    const auto& relaxed = statement.relaxed;
    if (!value.is_unknown() &&
        std::find(relaxed.begin(), relaxed.end(), slot.name) == relaxed.end())
      conditions.push_back({by.column, match_of(topic, by), value});
  }
  return conditions;
}

// Numbers, also those that are written as text, come in their order, and
// before what is none.
std::weak_ordering order_of(const Value& a, const Value& b) {
  const auto left = parse_number(a.text());
  const auto right = parse_number(b.text());
  if (left.is_unknown() != right.is_unknown())
    return left.is_unknown() <=> right.is_unknown();
  if (!left.is_unknown())
    return std::weak_order(left.number_or(0), right.number_or(0));
  return folded(a.text()) <=> folded(b.text());
}

void sort_rows(const ResultSet& rows, const std::string& order,
               std::vector<std::size_t>& chosen) {
  const auto columns = sort_columns(order);
  if (chosen.empty())
    return;
  std::ranges::stable_sort(chosen, [&](auto a, auto b) {
    for (const auto& [column, falling] : columns) {
      const auto compared =
          order_of(*rows.cell(a, column), *rows.cell(b, column));
      if (compared != 0)
        return falling ? compared > 0 : compared < 0;
    }
    return false;
  });
}

} // namespace

// Tables in scripts are small, so each condition walks through all rows that
// are left. Rows that are equal for `order` keep the order of the file.
ResultSet query_facts(const script::Program& program,
                      const script::Topic& topic, const Statement& statement) {
  const auto& source = topic.queries[statement.source];
  const auto& rows = program.facts[source.facts].rows;
  std::vector<std::size_t> chosen(rows.row_count());
  std::iota(chosen.begin(), chosen.end(), 0);
  for (const auto& condition : conditions_of(topic, source, statement))
    std::erase_if(chosen, [&](std::size_t row) {
      return !holds(condition, *rows.cell(row, condition.column));
    });
  sort_rows(rows, source.order, chosen);
  ResultSet result{rows.columns, {}};
  for (auto row : chosen)
    for (const auto& column : rows.columns)
      result.cells.push_back(*rows.cell(row, column));
  return result;
}

} // namespace parlour::dialogue
