// The plug-in MySQLDatabase (role Database): one database of a MariaDB server.
// It answers scripts as SQLiteDatabase does (docs/databases.md):
//
//  Connect(options)            Result(): the server answers
//  Query(sql, values, write?)  Result(rows) or Result(rows, changes)
//  Begin, Commit, Rollback     Result(): each session has its own
//
// Unasked: ValuesChanged(column, values) if a column of the option `columns`
// has other values than before, whoever wrote them.
//
// A failure is answered with Error(kind, message). A read whose connection is
// lost is repeated on another one; a write whose connection is lost before the
// server answered fails with kind InDoubt, and the script decides.
//
// Threads: a MariaDBPool talks to the server on a thread of its own and answers
// from there. The thread that calls the plug-in waits only when it starts and
// stops, or with the option `one-by-one`, which virtual time needs.
// MariaDBWatch has a thread of its own, too.
#pragma once

#include <memory>

#include "adapters/database/database_command.hpp"
#include "adapters/database/mariadb/connection/mariadb_options.hpp"
#include "adapters/database/statement.hpp"
#include "runtime/plugin/open_messages.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct DatabaseOrder;
class MariaDBPool;
class MariaDBWatch;

class MySQLDatabase : public IPlugin {
public:
  MySQLDatabase();
  ~MySQLDatabase() override;

  void stop() override;

protected:
  // Waits for the first connection. An unreachable server is no error: the
  // component starts, and tries again with the first message.
  Expected<void> on_start(const Options& options) override;
  void on_message(const Message& message) override;

private:
  void watch_values();
  void submit(DatabaseOrder order);
  bool is_this_database(const Value& wanted) const;
  void tell(const Message& message, StatementOutcome outcome);
  void fail_with(const Message& message, const Error& error);

  MariaDBOptions options_;
  OpenMessages open_;
  // It still answers messages while it is destroyed.
  std::unique_ptr<MariaDBPool> pool_;
  std::unique_ptr<MariaDBWatch> watch_;
};

PluginFactory mysql_database_factory();

} // namespace parlour::adapters
