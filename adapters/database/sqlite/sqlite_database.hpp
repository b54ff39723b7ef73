// The plug-in SQLiteDatabase (role Database): one SQLite database, either a
// file of the data folder or a copy in memory. Conversations under test each
// get a fresh copy (engine rule 7.5).
//
//  Connect(options)            Result(): the component has this database
//  Query(sql, values, write?)  Result(rows) or Result(rows, changes)
//  Begin, Commit, Rollback     Result(): one session at a time
//
// Unasked: ValuesChanged(column, values) if a column of the option `columns`
// has other values than before, whoever wrote them.
//
// A failure is answered with Error(kind, message). SQLite has one writer: while
// a session holds a transaction, messages of other sessions that write wait, at
// most `busy-timeout`. A file has a second connection for reading (WAL), so
// that reads outside of the transaction see the last committed state and do not
// wait. A database in memory has one connection only: there, reads wait as
// well.
//
// Threads: statements run on the thread that calls the plug-in, and block it.
// SQLiteWatch has one of its own.
#pragma once

#include <map>
#include <memory>

#include "adapters/database/database_command.hpp"
#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "adapters/database/sqlite/sqlite_options.hpp"
#include "adapters/database/sqlite/sqlite_transactions.hpp"
#include "adapters/database/sqlite/sqlite_watch.hpp"
#include "adapters/database/value_watch.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

class SQLiteDatabase : public IPlugin {
public:
  void stop() override;

protected:
  // Creates a missing file from schema and seed. Fails if the file is damaged.
  Expected<void> on_start(const Options& options) override;
  void on_message(const Message& message) override;

private:
  using Ticket = SQLiteTransactions::Ticket;

  Expected<void> open();
  Expected<void> open_memory_copy();
  Expected<void> create_missing() const;
  Expected<std::unique_ptr<SQLiteConnection>> connect() const;

  void handle(DatabaseCommand command, const Message& message);
  // Messages that wait for the end of another session's transaction.
  bool must_wait(DatabaseCommand command, const Message& message) const;
  void wait(const Message& message);
  void give_up_waiting(Ticket ticket);
  // Handles the waiting messages, in order, until one of them begins a
  // transaction.
  void let_others_on();

  // The values of columns.
  void watch_values();
  void note_written();
  void look_at_values();

  void check_connection(const Message& message);
  void query(const Message& message);
  void begin(const Message& message);
  void end(DatabaseCommand how, const Message& message);
  void notice_lost_transaction(const SessionId& session);
  void take_away(Ticket ticket);
  // Timers of the plug-in's host, one for each ticket: a holder's transaction
  // or a waiting message. The member function is called when the time is over.
  using TimeIsUp = void (SQLiteDatabase::*)(Ticket);
  void give_time(Ticket ticket, Milliseconds time, TimeIsUp time_is_up);
  void no_longer_timed(Ticket ticket);
  void fail_with(const Message& message, const Error& error);

  SQLiteOptions options_;
  // All writes, and every statement of a transaction. Null: not started, or
  // stopped.
  std::unique_ptr<SQLiteConnection> writer_;
  // Reads outside of the transaction. Null for a database in memory.
  std::unique_ptr<SQLiteConnection> reader_;
  SQLiteTransactions transactions_;
  std::map<Ticket, PluginHost::DelayId> delays_;
  ValueWatch values_;
  std::set<std::string> written_; // tables, in the transaction that is open
  std::unique_ptr<SQLiteWatch> watch_; // destroyed first: it calls
};

PluginFactory sqlite_database_factory();

} // namespace parlour::adapters
