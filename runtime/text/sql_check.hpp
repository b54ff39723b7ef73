// Checks of SQL that are possible without a database: whether a text is one
// select statement, whether it only looks, and whether a word can name a table
// or column (engine rule 6).
//
// The compiler checks topics and slots with them. Only the database knows the
// rest; `parlour check` asks it
// (tools/parlour/application/sql/sql_statements.hpp). All functions are pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour {

// Says why the text is not exactly one `select` or `with` statement; empty if
// it is, for SQLite and for MariaDB. A semicolon and comments may follow it.
std::string wrong_select(std::string_view sql);

// Whether the text is certainly one statement that only looks, for SQLite and
// for MariaDB: it changes nothing, locks nothing and writes no file. A text
// that is in doubt does not.
bool only_looks(std::string_view sql);

// Whether the text is a plain name, such as "level" or "rr_facility.level":
// parts of ASCII letters, digits and _ that begin with no digit, with points
// between them.
bool is_sql_name(std::string_view text);

// Whether the text names a column as a source of values: "db:table.column".
bool is_column_source(std::string_view text);

// A column that results are sorted by.
struct SortColumn {
  std::string name;
  bool falling = false;
};

// Reads an order such as "level desc, name". Returns nothing if the text holds
// anything but names with `asc` or `desc` (in lower case) behind them.
std::vector<SortColumn> sort_columns(std::string_view order);

} // namespace parlour
