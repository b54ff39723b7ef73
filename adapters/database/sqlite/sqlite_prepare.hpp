// Whether statements fit a database, without running them: for `check`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/database/sqlite/sqlite_image.hpp"

namespace parlour::adapters {

struct SQLiteProblem {
  std::string message;               // "no such column: nme"
  std::optional<std::size_t> offset; // byte of the statement
};

// A database in memory; for one thread at a time.
class SQLitePreparer {
public:
  static Expected<SQLitePreparer> open(const SQLiteImage& image);

  // What keeps the statement from being prepared; nothing where all is well.
  std::optional<SQLiteProblem> problem_of(const std::string& sql) const;

  // Every table, view and column, for "did you mean".
  std::vector<std::string> names() const;

private:
  explicit SQLitePreparer(SQLiteHandle handle) : handle_(std::move(handle)) {}

  SQLiteHandle handle_;
};

} // namespace parlour::adapters
