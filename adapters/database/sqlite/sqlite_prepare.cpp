#include "adapters/database/sqlite/sqlite_prepare.hpp"

#include <sqlite3.h>

namespace parlour::adapters {

Expected<SQLitePreparer> SQLitePreparer::open(const SQLiteImage& image) {
  return open_image(image).map(
      [](SQLiteHandle handle) { return SQLitePreparer(std::move(handle)); });
}

// Preparing checks syntax, tables and columns without reading any data.
std::optional<SQLiteProblem>
SQLitePreparer::problem_of(const std::string& sql) const {
  sqlite3_stmt* statement = nullptr;
  const auto code =
      sqlite3_prepare_v2(handle_.get(), sql.c_str(),
                         static_cast<int>(sql.size()), &statement, nullptr);
  const SQLiteStatement owner(statement);
  if (code == SQLITE_OK)
    return {};
  const auto offset = sqlite3_error_offset(handle_.get());
  return SQLiteProblem{sqlite3_errmsg(handle_.get()),
                       offset < 0
                           ? std::nullopt
                           : std::optional(static_cast<std::size_t>(offset))};
}

std::vector<std::string> SQLitePreparer::names() const {
  // pragma_table_info is a table-valued function: it lists the columns of each
  // table.
  constexpr const char* sql =
      "select name from sqlite_schema where type in ('table', 'view') union "
      "select info.name from sqlite_schema as t, pragma_table_info(t.name) as "
      "info where t.type in ('table', 'view')";
  sqlite3_stmt* statement = nullptr;
  std::vector<std::string> names;
  sqlite3_prepare_v2(handle_.get(), sql, -1, &statement, nullptr);
  const SQLiteStatement owner(statement);
  while (statement && sqlite3_step(statement) == SQLITE_ROW)
    if (const auto* text = sqlite3_column_text(statement, 0))
      names.emplace_back(reinterpret_cast<const char*>(text));
  return names;
}

} // namespace parlour::adapters
