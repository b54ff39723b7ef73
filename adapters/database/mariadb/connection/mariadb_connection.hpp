// MariaDBConnection is one connection to a MariaDB server, with a cache of
// prepared statements. Its operations are coroutines (task.hpp) and never
// block: when the server has not answered yet, the task is suspended, and
// whoever polls the socket resumes it. One thread can thus serve many
// connections:
//
//  auto task = connection.run(sql, values, Access::read);
//  connection.give_time(5s);
//  task.start();
//  while (!task.done())
//    // poll descriptor() for interest() until deadline(), then
//    connection.go_on(revents);
//  auto outcome = task.result();
//
// The one exception: looking up the name of a host may block. Not thread-safe;
// one task at a time may run on a connection.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "adapters/database/mariadb/connection/connection_state.hpp"
#include "adapters/database/mariadb/connection/mariadb_calls.hpp"
#include "adapters/database/mariadb/connection/mariadb_handle.hpp"
#include "adapters/database/mariadb/connection/mariadb_options.hpp"
#include "adapters/database/mariadb/connection/statement_cache.hpp"
#include "adapters/database/mariadb/connection/task.hpp"
#include "adapters/database/statement.hpp"

namespace parlour::adapters {

class MariaDBConnection {
public:
  using Moment = MariaDBCalls::Moment;
  using Outcome = Task<StatementOutcome>;

  // Whether to select the database of the options, or only to connect to the
  // server, because the database may not exist yet.
  enum class To : std::uint8_t { database, server };

  explicit MariaDBConnection(std::shared_ptr<const MariaDBOptions> options);
  MariaDBConnection(const MariaDBConnection&) = delete;
  MariaDBConnection& operator=(const MariaDBConnection&) = delete;

  // Connects. The kind of an error is Offline if the server cannot be reached,
  // Refused if it rejects the user, Timeout, or Database. A connection that
  // could not be opened is lost.
  Outcome open(To to);

  // Runs one statement of a script. `sql` is a text; `values` is a list for
  // placeholders `?` or a map for placeholders `:name`. The kind of an error is
  // Type if the values do not fit, Refused if the statement may not run, Limit,
  // Timeout, Offline or Database.
  Outcome run(Value sql, Value values, Access access);

  // Transactions. A failed `end` leaves the transaction in an unknown state;
  // close the connection then, which rolls back.
  enum class End : std::uint8_t { commit, rollback };
  Outcome begin();
  Outcome end(End how);

  // Runs a statement of the platform, without placeholders or result.
  Outcome control(std::string sql);

  // Sets the deadline of the current or next task. Past it, go_on ends the task
  // with an error of kind Timeout, and the connection is lost.
  void give_time(Milliseconds time) {
    calls_.give_time(time);
  }

  // The interface for whoever polls. Without a task, a connection is only
  // polled for input, which then means that the server has closed it.
  int descriptor() const {
    return handle_.descriptor();
  }
  // The poll events to wait for: POLLIN, POLLOUT.
  short interest() const;
  // Moment::max() if no task is suspended.
  Moment deadline() const {
    return calls_.deadline();
  }
  // Resumes the suspended task. `ready` is what poll returned in revents, or 0
  // if the deadline has passed.
  void go_on(short ready) {
    calls_.go_on(ready);
  }

  // What has become of it. One that is lost cannot be opened a second time.
  const ConnectionState& state() const {
    return state_;
  }
  // The access mode of the session. A statement with the same access runs at
  // once; another one first switches the mode, which costs a round trip.
  Access access() const {
    return access_;
  }

private:
  Expected<void> check_kind(const PreparedStatement& prepared,
                            Access access) const;
  Task<Expected<void>> allow(Access access);
  Task<Expected<PreparedStatement*>> prepare(std::string sql);
  Outcome execute(PreparedStatement& prepared);
  Outcome collect(PreparedStatement& prepared);
  // Closes a statement on the server and removes it from the cache.
  Task<Expected<void>> forget(PreparedStatement& prepared);
  // Record the state after an error and put it into words.
  tl::unexpected<Error> failure(std::string_view sql);
  tl::unexpected<Error> failure(const PreparedStatement& prepared);

  std::shared_ptr<const MariaDBOptions> options_;
  // Outlives the handle: closing a statement then only frees memory.
  StatementCache cache_;
  MariaDBHandle handle_;
  MariaDBCalls calls_;
  ConnectionState state_;
  Access access_ = Access::write;
  bool in_transaction_ = false;
};

// Runs a task to its end and blocks until then. For threads that may wait.
StatementOutcome carry_out(MariaDBConnection& connection,
                           MariaDBConnection::Outcome task);

} // namespace parlour::adapters
