// What can be said about SQL without a database: whether a statement is one
// select, whether a word can be a table or column (engine rule 6).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

// What keeps the text from being one select statement, as a sentence; empty
// where nothing does.
std::string wrong_select(std::string_view sql);

// "level", "rr_facility.level": letters, digits and _ only.
bool is_sql_name(std::string_view text);

// "db:table.column".
bool is_column_source(std::string_view text);

// One of the columns to sort by.
struct SortColumn {
  std::string name;
  bool falling = false;
};

// Of "name", "level desc, name"; none where it is no such order.
std::vector<SortColumn> sort_columns(std::string_view order);

} // namespace parlour::script
