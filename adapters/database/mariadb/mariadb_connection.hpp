// One connection to a MariaDB server and the statements prepared on it. Never
// waits: what it does is a Task, put down where the server has not answered
// yet; whoever polls takes it up. Only a host's name may take a moment to be
// looked up. For one thread at a time, one task at a time.
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

  enum class To : std::uint8_t { database, server };

  explicit MariaDBConnection(std::shared_ptr<const MariaDBOptions> options);
  MariaDBConnection(const MariaDBConnection&) = delete;
  MariaDBConnection& operator=(const MariaDBConnection&) = delete;
  ~MariaDBConnection();

  // Kinds: Offline where nobody is there, Refused who may not, Timeout,
  // Database for all else.
  Outcome open(To to);

  // Runs one statement of a script, a text. `values` is a list for `?` or a map
  // for
  // `:name`. Kinds: Type for values that do not fit, Refused for a statement
  // that may not run, Limit, Timeout, Offline, Database.
  Outcome run(Value sql, Value values, Access access);

  enum class End : std::uint8_t { commit, rollback };
  Outcome begin();
  Outcome end(End how);

  // A statement of the platform's own.
  Outcome control(std::string sql);

  // How long one task may take from now on, before the connection is given up.
  void give_time(Milliseconds time);

  // For whoever polls: what a task waits for.
  int descriptor() const; // -1: nothing
  short interest() const; // POLLIN, POLLOUT
  Moment deadline() const;
  // Takes the task up: with what poll says, or 0 where the deadline has come.
  void go_on(short ready);

  // Of no use any more.
  bool lost() const {
    return lost_;
  }
  // The last statement was on its way when the connection was lost: nobody
  // knows whether it was carried out.
  bool in_doubt() const {
    return in_doubt_;
  }
  // The last error rolled the transaction back.
  bool ended_transaction() const {
    return ended_transaction_;
  }
  // The last error's number; 0: none.
  unsigned code() const {
    return code_;
  }
  // What statements may do without a word to the server.
  Access access() const {
    return access_;
  }

private:
  struct Prepared {
    std::string sql;
    std::vector<std::string> names; // of its placeholders
    StatementKind kind;
    st_mysql_stmt* statement;
    MariaDBParameters parameters;
    std::unique_ptr<MariaDBRow> row; // of the last result, for the next
  };
  // Most recently used first.
  using Cache = std::list<Prepared>;

  // A call of the library that goes on when the server has answered.
  class Pending {
  public:
    virtual int proceed(int ready) = 0; // returns what it waits for; 0: done

  protected:
    ~Pending() = default;
  };
  template <class Result, class Continue, class Handle>
  class Call;

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
  Task<Expected<void>> forget_oldest();
  Task<Expected<void>> forget_front();
  Outcome collect(Prepared& prepared);
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
  Pending* pending_ = nullptr;      // what the task waits for
  std::coroutine_handle<> waiting_; // where it goes on after that
  int wanted_ = 0;                  // the library's flags
};

// Carries a task out here and now, on a thread that may wait.
StatementOutcome carry_out(MariaDBConnection& connection,
                           MariaDBConnection::Outcome task);

} // namespace parlour::adapters
