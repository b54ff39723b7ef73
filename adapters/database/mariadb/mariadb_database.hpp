// The plug-in MySQLDatabase (role Database): a database of a MariaDB server.
// It answers what SQLiteDatabase answers:
//
//   Connect(options)            Result()   is it there?
//   Query(sql, values, write?)  Result(rows) or Result(rows, changes)
//   Begin, Commit, Rollback     Result()   each session its own
//
// Anything that goes wrong is Error(kind, message). A query that only reads
// and loses its connection is asked again; one that writes is in doubt.
// A thread of its own waits for the server, never the one that calls.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>

#include "adapters/database/database_command.hpp"
#include "adapters/database/mariadb/mariadb_options.hpp"
#include "adapters/database/statement.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct DatabaseOrder;
class MariaDBPool;

class MySQLDatabase : public IPlugin {
public:
  MySQLDatabase();
  ~MySQLDatabase() override;

  void stop() override;

protected:
  // Waits for the first connection. Where the server cannot be reached it
  // comes up all the same, and goes on trying when it is asked something.
  Expected<void> on_start(const Options& options) override;
  void on_message(const Message& message) override;

private:
  void submit(DatabaseOrder order);
  bool is_this_database(const Value& wanted) const;
  void tell(const Message& message, StatementOutcome outcome);
  void fail_with(const Message& message, const Error& error);

  MariaDBOptions options_;
  std::mutex mutex_;
  std::condition_variable told_; // for who waits for each answer
  std::size_t untold_ = 0;
  std::unique_ptr<MariaDBPool> pool_; // the last: it tells while it ends
};

PluginFactory mysql_database_factory();

} // namespace parlour::adapters
