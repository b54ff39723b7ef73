// The connections of one MySQLDatabase, driven by one thread of its own, and
// the messages that wait for them. A message gets the connection that is free,
// one inside of a transaction its own; connections are made when they are
// needed, and again, after a while that grows, when they were lost.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include <poll.h>

#include "adapters/database/database_command.hpp"
#include "adapters/database/lost_transactions.hpp"
#include "adapters/database/mariadb/mariadb_connection.hpp"
#include "runtime/base/message.hpp"

namespace parlour::adapters {

// What a message asks of the database.
struct DatabaseOrder {
  DatabaseCommand kind = DatabaseCommand::query;
  Message message; // query: its SQL and values
  bool write = false;
};

class MariaDBPool {
public:
  // What came of it; from the pool's thread, or who submits too much.
  using Tell = std::function<void(const Message&, StatementOutcome)>;
  using Log = std::function<void(const std::string&)>;

  MariaDBPool(MariaDBOptions options, Tell tell, Log log);
  ~MariaDBPool(); // tells all that are left; what is open is rolled back

  // The outcome of the first connection, once: what is wrong with the settings
  // shows there. Waits for it.
  Expected<void> first_connection();

  // From any thread; never waits. Every order is told about once.
  void submit(DatabaseOrder order);

private:
  using Moment = MariaDBConnection::Moment;

  struct Waiting {
    DatabaseOrder order;
    Moment deadline;
    std::size_t deaths = 0; // of connections, over it
  };

  struct Told {
    Message message;
    StatementOutcome outcome;
  };

  // A connection and what goes on there.
  struct Worker {
    std::unique_ptr<MariaDBConnection> connection;
    MariaDBConnection::Outcome task;  // before the connection in its end
    std::optional<Waiting> waiting;   // what the task is about; none: opening
    std::optional<SessionId> session; // whose transaction it is
    Moment transaction_ends = Moment::max();

    bool is_idle() const {
      return connection && !task;
    }
  };

  void work();
  bool take_in();
  void hand_over();
  bool may_sleep();
  bool is_busy() const;
  void wake();
  void assign();
  bool assign(Waiting& waiting);
  bool open_one();
  void start(Worker& worker, Waiting waiting);
  std::optional<Error> objection(const Waiting& waiting);
  Worker* holder(const SessionId& session) const;
  Worker* free_worker(Access access);
  bool any_connected() const;
  bool is_opening() const;
  bool somebody_needs_one() const;
  void wait_for_events();
  Milliseconds time_to_sleep();
  Moment next_moment() const;
  void look_after(Worker& worker, short ready, Moment now);
  void expire(Moment now);
  Error why_it_waited() const;
  void conclude(Worker& worker);
  void opened(Worker& worker, const StatementOutcome& outcome);
  void succeeded(Worker& worker, Waiting waiting, StatementOutcome outcome);
  void failed(Worker& worker, Waiting waiting, const Error& error);
  void lose(Worker& worker, Waiting waiting, const Error& error);
  void drop(Worker& worker);
  void take_away(Worker& worker);
  void tell(Waiting&& waiting, StatementOutcome outcome);
  void end();
  void drop_copy();

  const std::shared_ptr<const MariaDBOptions> options_;
  const Tell tell_;
  const Log log_;
  std::promise<Expected<void>> first_;
  bool first_told_ = false;

  std::mutex mutex_; // for the four that follow
  std::vector<Waiting> inbox_;
  std::size_t pending_ = 0;   // not told about yet
  bool wants_waking_ = false; // sleeps, and could do something with an order
  bool over_ = false;

  // Of the thread alone.
  std::vector<std::unique_ptr<Worker>> workers_;
  std::deque<Waiting> waiting_;
  std::deque<Waiting> round_;  // of them, while they are assigned
  std::vector<Waiting> taken_; // of the inbox, for its memory
  std::vector<Told> told_;     // handed over when the next ones are under way
  std::vector<pollfd> polled_; // for its memory
  LostTransactions lost_;
  bool set_up_ = false;
  unsigned failures_ = 0;          // to connect, one after the other
  Moment next_attempt_{};          // long ago, but to be reckoned with
  Moment open_at_ = Moment::max(); // somebody waits for the next attempt
  std::optional<Error> trouble_;   // why it could not connect

  int wake_ = -1; // an eventfd that ends the thread's sleep
  std::thread thread_;
};

} // namespace parlour::adapters
