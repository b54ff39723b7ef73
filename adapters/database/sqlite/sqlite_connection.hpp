// One connection to an SQLite database and the statements prepared on it. For
// one thread at a time. Everything that a script can cause comes back as an
// Error whose sentence begins with the statement's first words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

#include "adapters/database/statement.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace parlour::adapters {

// What one statement may cost; beyond it, an Error of kind Limit.
struct SQLiteLimits {
  std::size_t rows = 10'000;
  std::size_t bytes = 4 << 20;       // of a result's cells
  std::uint64_t steps = 100'000'000; // of SQLite's machine, about a second
  std::size_t statements = 64;       // kept prepared
};

struct CloseSQLite {
  void operator()(sqlite3* handle) const;
};
struct FinalizeStatement {
  void operator()(sqlite3_stmt* statement) const;
};
using SQLiteHandle = std::unique_ptr<sqlite3, CloseSQLite>;
using SQLiteStatement = std::unique_ptr<sqlite3_stmt, FinalizeStatement>;

class SQLiteConnection {
public:
  // Takes over an open handle and makes it safe for statements of scripts:
  // no ATTACH, no PRAGMA, no transaction control, no loading of libraries.
  SQLiteConnection(SQLiteHandle handle, SQLiteLimits limits,
                   Milliseconds busy_timeout);
  SQLiteConnection(const SQLiteConnection&) = delete;
  SQLiteConnection& operator=(const SQLiteConnection&) = delete;
  ~SQLiteConnection();

  // Runs one statement. `values` is a list for `?` or a map for `:name`;
  // unknown where there is no placeholder. Kinds: Type for values that do not
  // fit, Refused for a statement that may not run, Limit, Database.
  Expected<StatementAnswer> run(const std::string& sql, const Value& values,
                                Access access);

  Expected<void> begin();
  Expected<void> commit();
  Expected<void> rollback();

  // Some failures end a transaction by themselves.
  bool in_transaction() const;

private:
  struct Prepared {
    std::string sql;
    SQLiteStatement statement;
    Columns columns; // as of that many preparations
    int preparations = -1;
  };

  // Most recently used first.
  using Cache = std::list<Prepared>;

  Expected<Prepared*> prepared(const std::string& sql);
  Expected<SQLiteStatement> prepare(const std::string& sql);
  Expected<void> check_rest(const std::string& sql, const char* rest);
  Expected<StatementAnswer> collect(Prepared& prepared);
  Expected<void> control(const char* sql);
  tl::unexpected<Error> failure(const std::string& sql, int code);

  static int authorize(void* self, int action, const char* first,
                       const char* second, const char* database,
                       const char* trigger);
  static int progress(void* self);

  SQLiteHandle handle_;
  SQLiteLimits limits_;
  Cache cache_;
  std::unordered_map<std::string_view, Cache::iterator> places_;
  std::string refused_; // what the authorizer last refused
  std::uint64_t steps_left_ = 0;
  bool controlling_ = false; // while begin, commit or rollback run
};

} // namespace parlour::adapters
