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

#include <chrono>
#include <coroutine>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "adapters/database/mariadb/mariadb_dialect.hpp"
#include "adapters/database/mariadb/mariadb_options.hpp"
#include "adapters/database/mariadb/mariadb_values.hpp"
#include "adapters/database/mariadb/task.hpp"
#include "adapters/database/statement.hpp"

struct st_mysql;
struct st_mysql_stmt;

namespace parlour::adapters {

class MariaDBConnection {
public:
  using Moment = std::chrono::steady_clock::time_point;
  using Outcome = Task<StatementOutcome>;

  // Whether to select the database of the options, or only to connect to the
  // server, because the database may not exist yet.
  enum class To : std::uint8_t { database, server };

  explicit MariaDBConnection(std::shared_ptr<const MariaDBOptions> options);
  MariaDBConnection(const MariaDBConnection&) = delete;
  MariaDBConnection& operator=(const MariaDBConnection&) = delete;
  ~MariaDBConnection();

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
  void give_time(Milliseconds time);

  // The interface for whoever polls. Without a task, a connection is only
  // polled for input, which then means that the server has closed it.
  int descriptor() const;
  // The poll events to wait for: POLLIN, POLLOUT.
  short interest() const;
  // Moment::max() if no task is suspended.
  Moment deadline() const;
  // Resumes the suspended task. `ready` is what poll returned in revents, or 0
  // if the deadline has passed.
  void go_on(short ready);

  // Whether the connection is unusable. It cannot be opened a second time.
  bool lost() const {
    return lost_;
  }
  // Whether the connection was lost after the last statement was sent and
  // before the server answered: nobody knows whether the statement was
  // executed.
  bool in_doubt() const {
    return in_doubt_;
  }
  // Whether the last error made the server roll the transaction back.
  bool ended_transaction() const {
    return ended_transaction_;
  }
  // The number of the last error (mariadb_errors.hpp), or 0 if there was none.
  unsigned code() const {
    return code_;
  }
  // The access mode of the session. A statement with the same access runs at
  // once; another one first switches the mode, which costs a round trip.
  Access access() const {
    return access_;
  }

private:
  struct Prepared {
    std::string sql;
    // The names of its placeholders, "" for `?`.
    std::vector<std::string> names;
    StatementKind kind;
    st_mysql_stmt* statement;
    MariaDBParameters parameters;
    // The buffers of the last result, kept for the next execution.
    std::unique_ptr<MariaDBRow> row;
  };
  // Least recently used last. `places_` finds an entry by its SQL; its keys
  // point into the entries.
  using Cache = std::list<Prepared>;

  // A call of the C library that has begun and waits for the server.
  class Pending {
  public:
    // Continues the call. Returns the flags it waits for next, or 0 if it is
    // done.
    virtual int proceed(int ready) = 0;

  protected:
    ~Pending() = default;
  };
  template <class Result, class Continue, class Handle>
  class Call;

  // Starts a non-blocking call of the C library; co_await its result.
  template <class Result, class Start, class Continue, class Handle,
            class... Arguments>
  Call<Result, Continue, Handle> finish(Start start, Continue proceed,
                                        Handle* handle, Arguments... arguments);

  void set_options();
  Expected<void> check_kind(const Prepared& prepared, Access access) const;
  Task<Expected<void>> allow(Access access);
  Prepared* prepared(const std::string& sql);
  Task<Expected<Prepared*>> prepare(std::string sql);
  Outcome execute(Prepared& prepared);
  // Close a statement on the server and remove it from the cache.
  Task<Expected<void>> forget_oldest();
  Task<Expected<void>> forget_front();
  Outcome collect(Prepared& prepared);
  // Record the state after an error and put it into words.
  tl::unexpected<Error> failure(std::string_view sql, unsigned code,
                                const char* reason);
  tl::unexpected<Error> failure(std::string_view sql);
  tl::unexpected<Error> failure(const Prepared& prepared);

  std::shared_ptr<const MariaDBOptions> options_;
  st_mysql* handle_;
  Cache cache_;
  std::unordered_map<std::string_view, Cache::iterator> places_;
  Access access_ = Access::write;
  bool in_transaction_ = false;
  bool lost_ = false;
  bool in_doubt_ = false;
  bool ended_transaction_ = false;
  unsigned code_ = 0;
  Moment deadline_ = Moment::max();
  // What the suspended task waits for, where to resume it, and the flags
  // (MYSQL_WAIT_READ …) that the library wants to see.
  Pending* pending_ = nullptr;
  std::coroutine_handle<> waiting_;
  int wanted_ = 0;
};

// Runs a task to its end and blocks until then. For threads that may wait.
StatementOutcome carry_out(MariaDBConnection& connection,
                           MariaDBConnection::Outcome task);

} // namespace parlour::adapters
