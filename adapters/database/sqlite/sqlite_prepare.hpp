// Checks whether SQL statements fit a database without running them. `parlour
// check` uses it to find misspelt tables and columns in an application.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/database/sqlite/sqlite_image.hpp"

namespace parlour::adapters {

struct SQLiteProblem {
  // SQLite's words: "no such column: nme".
  std::string message;
  // The byte of the statement at which the problem is, if SQLite knows it.
  std::optional<std::size_t> offset;
};

// A copy of the database in memory. Not thread-safe.
class SQLitePreparer {
public:
  static Expected<SQLitePreparer> open(const SQLiteImage& image);

  // The reason why the statement cannot be prepared, or nothing if it can.
  std::optional<SQLiteProblem> problem_of(const std::string& sql) const;

  // The names of all tables, views and columns, for "did you mean".
  std::vector<std::string> names() const;

private:
  explicit SQLitePreparer(SQLiteHandle handle) : handle_(std::move(handle)) {}

  SQLiteHandle handle_;
};

} // namespace parlour::adapters
