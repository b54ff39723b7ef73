#include "adapters/database/column_reference.hpp"

#include <algorithm>
#include <string_view>

namespace parlour::adapters {

namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return is_letter(c) || (c >= '0' && c <= '9');
         });
}

} // namespace

Expected<ColumnReference> parse_column(const std::string& reference) {
  std::string_view rest = reference;
  if (rest.starts_with("db:"))
    rest.remove_prefix(3);
  // Without a point the second part is empty, which is_name rejects.
  const auto point = std::min(rest.find('.'), rest.size());
  const auto table = rest.substr(0, point);
  const auto column = rest.substr(std::min(point + 1, rest.size()));
  if (!is_name(table) || !is_name(column))
    return fail(ErrorKind::settings,
                "'" + reference +
                    "' is not a column; write it as 'db:table.column'.");
  return ColumnReference{std::string(table), std::string(column)};
}

// Both names are plain, so quoting them is safe.
std::string select_values_of(const ColumnReference& place) {
  const auto column = "\"" + place.column + "\"";
  return "select distinct " + column + " from \"" + place.table + "\" where " +
         column + " is not null order by 1";
}

} // namespace parlour::adapters
