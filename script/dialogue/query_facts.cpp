// Queries of <facts>: a table in the program, read as a database's would be
// (engine rule 6).
#include <algorithm>
#include <numeric>
#include <utility>

#include "script/dialogue/knowledge_query.hpp"
#include "script/dialogue/spelling.hpp"

namespace parlour::dialogue {

namespace {

using script::Match;
using script::QueryBy;

struct Condition {
  std::string column;
  Match match = Match::equal;
  Value value;
};

bool equal(const Value& cell, const Value& value) {
  if (cell.if_string() && value.if_string())
    return folded(*cell.if_string()) == folded(*value.if_string());
  return cell == value;
}

bool holds(const Condition& condition, const Value& cell) {
  if (cell.is_unknown())
    return false;
  if (condition.match == Match::equal)
    return equal(cell, condition.value);
  const auto at = folded(cell.text()).find(folded(condition.value.text()));
  return condition.match == Match::prefix ? at == 0 : at != std::string::npos;
}

const script::FactTable* table_of(const script::Program& program,
                                  const std::string& name) {
  auto found =
      std::find_if(program.facts.begin(), program.facts.end(),
                   [&](const auto& table) { return table.name == name; });
  if (found != program.facts.end())
    return &*found;
  return name.empty() && program.facts.size() == 1 ? &program.facts.front()
                                                   : nullptr;
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
      conditions.push_back(
          {by.column, by.match == Match::equal ? slot.match : by.match, value});
  }
  return conditions;
}

bool has_column(const ResultSet& rows, const std::string& column) {
  return rows.row_count() == 0 || rows.cell(0, column);
}

bool less(const Value& a, const Value& b) {
  if (a.if_string() && b.if_string())
    return folded(*a.if_string()) < folded(*b.if_string());
  return a.number_or(0) < b.number_or(0);
}

// "name" or "level desc".
void sort_rows(const ResultSet& rows, const std::string& order,
               std::vector<std::size_t>& chosen) {
  const auto words = words_of(order);
  if (words.empty() || !has_column(rows, order.substr(0, order.find(' '))))
    return;
  const auto column = order.substr(0, order.find(' '));
  const bool falling = words.back() == "desc";
  std::stable_sort(chosen.begin(), chosen.end(), [&](auto a, auto b) {
    const auto& left = *rows.cell(falling ? b : a, column);
    return less(left, *rows.cell(falling ? a : b, column));
  });
}

} // namespace

Expected<ResultSet> query_facts(const script::Program& program,
                                const script::Topic& topic, const Frame&,
                                const Statement& statement) {
  const auto& source = topic.queries[statement.source];
  const auto* table = table_of(program, statement.name);
  if (!table)
    return fail(ErrorKind::database,
                "there are no <facts> named '" + statement.name + "'");
  const auto& rows = table->rows;
  std::vector<std::size_t> chosen(rows.row_count());
  std::iota(chosen.begin(), chosen.end(), 0);
  for (const auto& condition : conditions_of(topic, source, statement)) {
    if (!has_column(rows, condition.column))
      return fail(ErrorKind::database, "the <facts> '" + statement.name +
                                           "' have no attribute '" +
                                           condition.column + "'");
    std::erase_if(chosen, [&](std::size_t row) {
      return !holds(condition, *rows.cell(row, condition.column));
    });
  }
  sort_rows(rows, source.order, chosen);
  ResultSet result{rows.columns, {}};
  for (auto row : chosen)
    for (const auto& column : rows.columns)
      result.cells.push_back(*rows.cell(row, column));
  return result;
}

} // namespace parlour::dialogue
