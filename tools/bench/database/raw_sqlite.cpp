#include <memory>

#include <sqlite3.h>

#include "tools/bench/database/facility_table.hpp"
#include "tools/bench/database/raw_queries.hpp"

namespace parlour::tools {

namespace {

using Database = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;
using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;

// The same rows as the component's database has.
Database facilities_in_memory() {
  sqlite3* opened = nullptr;
  sqlite3_open(":memory:", &opened);
  const auto all = facility_schema() + facility_seed();
  sqlite3_exec(opened, all.c_str(), nullptr, nullptr, nullptr);
  return {opened, &sqlite3_close};
}

Statement prepared(sqlite3* database) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, facility_query, -1, &statement, nullptr);
  return {statement, &sqlite3_finalize};
}

// Returns the letters of the description; the other cells are read as well, as
// a component does.
std::size_t ask(sqlite3_stmt* statement, const std::string& name) {
  sqlite3_bind_text(statement, 1, name.data(), static_cast<int>(name.size()),
                    SQLITE_STATIC);
  std::size_t letters = 0;
  if (sqlite3_step(statement) == SQLITE_ROW)
    for (int i = 0; i < static_cast<int>(facility_columns); ++i)
      if (sqlite3_column_text(statement, i) &&
          i == static_cast<int>(description_column))
        letters = static_cast<std::size_t>(sqlite3_column_bytes(statement, i));
  sqlite3_reset(statement);
  return letters;
}

} // namespace

Expected<Measured> raw_sqlite(std::size_t count) {
  const auto database = facilities_in_memory();
  const auto statement = prepared(database.get());
  if (!statement)
    return fail(ErrorKind::database, sqlite3_errmsg(database.get()));
  std::size_t letters = 0;
  const StopWatch watch(0);
  for (std::size_t i = 0; i < count; ++i)
    letters += ask(statement.get(), facility_name(i));
  return watch.stop(count, std::to_string(letters));
}

} // namespace parlour::tools
