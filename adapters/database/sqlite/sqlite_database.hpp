// The plug-in SQLiteDatabase (role Database; engine rule 7.5): one database, a
// file of the data folder or a copy in memory.
//
//   Connect(options)            Result()   is it there?
//   Query(sql, values, write?)  Result(rows) or Result(rows, changes)
//   Begin, Commit, Rollback     Result()   a session at a time
//
// Anything that goes wrong is Error(kind, message). While one session holds a
// transaction, what others write waits; with a file they go on reading what
// was there before.
#pragma once

#include <map>
#include <memory>

#include "adapters/database/database_command.hpp"
#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "adapters/database/sqlite/sqlite_options.hpp"
#include "adapters/database/sqlite/sqlite_transactions.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

class SQLiteDatabase : public IPlugin {
public:
  void stop() override;

protected:
  // Makes a missing file; fails for one that is damaged.
  Expected<void> on_start(const Options& options) override;
  void on_message(const Message& message) override;

private:
  using Ticket = SQLiteTransactions::Ticket;

  Expected<void> open();
  Expected<void> open_memory_copy();
  Expected<void> create_missing() const;
  Expected<std::unique_ptr<SQLiteConnection>> connect() const;

  void handle(DatabaseCommand command, const Message& message);
  bool must_wait(DatabaseCommand command, const Message& message) const;
  void wait(const Message& message);
  void give_up_waiting(Ticket ticket);
  void let_others_on();

  void check_connection(const Message& message);
  void query(const Message& message);
  void begin(const Message& message);
  void end(DatabaseCommand how, const Message& message);
  void notice_lost_transaction(const SessionId& session);
  void take_away(Ticket ticket);
  // For who holds or waits with the ticket: what happens after so long.
  using TimeIsUp = void (SQLiteDatabase::*)(Ticket);
  void give_time(Ticket ticket, Milliseconds time, TimeIsUp time_is_up);
  void no_longer_timed(Ticket ticket);
  void fail_with(const Message& message, const Error& error);

  SQLiteOptions options_;
  std::unique_ptr<SQLiteConnection> writer_; // and all of a transaction
  std::unique_ptr<SQLiteConnection> reader_; // none in memory
  SQLiteTransactions transactions_;
  std::map<Ticket, PluginHost::DelayId> delays_;
};

PluginFactory sqlite_database_factory();

} // namespace parlour::adapters
