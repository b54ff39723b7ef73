// SQLiteConnection is one connection to an SQLite database, with a cache of
// prepared statements. It runs the statements of scripts, so it restricts what
// they may do and how much they may cost.
//
// Everything that a script can cause is returned as an Error whose message
// quotes the statement. Not thread-safe: one thread at a time may use a
// connection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "adapters/database/statement.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace parlour::adapters {

// What one statement may cost. A statement that exceeds a limit fails with an
// error of kind Limit.
struct SQLiteLimits {
  // The size of a result: its rows, and the bytes of its cells.
  std::size_t rows = 10'000;
  std::size_t bytes = 4 << 20;
  // Instructions of SQLite's virtual machine; these take about a second.
  std::uint64_t steps = 100'000'000;
  // How many prepared statements are kept. At least one is.
  std::size_t statements = 64;
};

// Deleters, so that handles of the C library can be owned by unique_ptr.
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
  // Takes ownership of an open handle and restricts it: ATTACH, PRAGMA,
  // transaction control and loading of libraries are refused.
  SQLiteConnection(SQLiteHandle handle, SQLiteLimits limits,
                   Milliseconds busy_timeout);
  SQLiteConnection(const SQLiteConnection&) = delete;
  SQLiteConnection& operator=(const SQLiteConnection&) = delete;
  ~SQLiteConnection();

  // Runs one statement. `values` is a list for placeholders `?`, a map for
  // placeholders `:name`, or unknown if the statement has none. The kind of an
  // error is Type if the values do not fit, Refused if the statement may not
  // run, Limit, Timeout if another program holds a lock, or Database.
  Expected<StatementAnswer> run(const std::string& sql, const Value& values,
                                Access access);

  // The texts of the only column of a query of the platform, within limits of
  // its own.
  Expected<std::vector<std::string>> texts(const std::string& sql,
                                           const SQLiteLimits& limits);

  // The tables that statements have changed rows of since the last call.
  std::set<std::string> take_written();

  // Transactions. `begin` takes the write lock at once, so that a later write
  // of the same transaction cannot fail because another connection wrote first.
  Expected<void> begin();
  Expected<void> commit();
  Expected<void> rollback();

  // Asks SQLite, which ends a transaction by itself after some errors.
  bool in_transaction() const;

private:
  struct Prepared {
    std::string sql;
    SQLiteStatement statement;
    // The names of the result's columns, valid for this number of preparations:
    // SQLite prepares a statement again when the tables have changed.
    Columns columns;
    int preparations = -1;
    std::vector<std::string> writes = {}; // tables, some of them twice
  };

  // Least recently used last. `places_` finds an entry by its SQL; its keys
  // point into the entries.
  using Cache = std::list<Prepared>;

  Expected<Prepared*> prepared(const std::string& sql);
  Expected<SQLiteStatement> prepare(const std::string& sql);
  Expected<void> check_rest(const std::string& sql, const char* rest);
  Expected<StatementAnswer> collect(Prepared& prepared);
  Expected<void> control(const char* sql);
  tl::unexpected<Error> failure(const std::string& sql, int code);

  // Callbacks of the C library; `self` is the connection.
  static int authorize(void* self, int action, const char* first,
                       const char* second, const char* database,
                       const char* trigger);
  static int progress(void* self);

  SQLiteHandle handle_;
  SQLiteLimits limits_;
  Cache cache_;
  std::unordered_map<std::string_view, Cache::iterator> places_;
  // The reason of the authorizer's last refusal, for the error message.
  std::string refused_;
  // The tables that the statement which is being prepared writes to.
  std::vector<std::string> writes_;
  std::set<std::string> written_;
  // Counts down while a statement runs.
  std::uint64_t steps_left_ = 0;
  // True while begin, commit or rollback run, which scripts may not execute.
  bool controlling_ = false;
};

} // namespace parlour::adapters
