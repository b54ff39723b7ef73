#include "runtime/base/result_rows.hpp"

#include <set>
#include <utility>

namespace parlour {

namespace {

std::string numbered(const std::string& name,
                     const std::set<std::string>& taken) {
  int number = 2;
  while (taken.contains(name + '_' + std::to_string(number)))
    ++number;
  return name + '_' + std::to_string(number);
}

std::vector<std::string> distinct_names(const Columns& columns) {
  std::set<std::string> taken(columns.begin(), columns.end());
  std::set<std::string> used;
  std::vector<std::string> names;
  for (const auto& column : columns) {
    names.push_back(used.contains(column) ? numbered(column, taken) : column);
    used.insert(names.back());
    taken.insert(names.back());
  }
  return names;
}

} // namespace

List rows_as_maps(const ResultSet& result) {
  const auto names = distinct_names(result.columns);
  List rows;
  rows.reserve(result.row_count());
  auto cell = result.cells.begin();
  for (std::size_t row = 0; row < result.row_count(); ++row) {
    Map map;
    for (const auto& name : names)
      map.set(name, *cell++);
    rows.emplace_back(std::move(map));
  }
  return rows;
}

} // namespace parlour
