// MariaDBPool owns the connections of one MySQLDatabase and carries out what
// PoolPolicy decides. A loop of its own drives all connections.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "adapters/database/mariadb/connection/mariadb_connection.hpp"
#include "adapters/database/mariadb/pool_policy.hpp"
#include "adapters/loop/alarm.hpp"
#include "adapters/loop/watch.hpp"

namespace parlour::adapters {

class MariaDBPool {
public:
  // Receives the outcome of an order. It is called on the pool's thread, or on
  // the submitting thread if too many orders wait.
  using Tell = std::function<void(const Message&, StatementOutcome)>;
  using Log = std::function<void(const std::string&)>;

  // Connects at once, on the thread of the loop, which is the pool's own.
  MariaDBPool(MariaDBOptions options, std::unique_ptr<Loop> loop, Tell tell,
              Log log);
  // Answers all orders that are left, rolls back open transactions, and stops
  // the loop. Blocks for as long as dropping a copy takes.
  ~MariaDBPool();

  // Blocks until the first attempt to connect has ended, and returns its
  // outcome, in which mistakes of the settings show. Call it once.
  Expected<void> first_connection();

  // Queues an order. Thread-safe; never blocks. Every order gets exactly one
  // outcome.
  void submit(DatabaseOrder order);

private:
  using Moment = PoolPolicy::Moment;

  struct Submitted {
    DatabaseOrder order;
    Moment deadline;
  };

  // A connection and what happens on it. The members are destroyed from the
  // last to the first: the task, which refers to the connection, goes first.
  struct Worker {
    Worker(MariaDBPool& pool, PoolPolicy::Place number);

    const PoolPolicy::Place place;
    // Waits for the connection's socket.
    Watch watch;
    std::unique_ptr<MariaDBConnection> connection;
    // Empty: the connection is idle, or there is none.
    MariaDBConnection::Outcome task;
    bool is_opening = false;
  };

  // What follows each event: take orders, decide, report outcomes, wait.
  void turn();
  void turn_soon();
  bool take_in();
  void hand_over();
  void wait_for_events();
  bool may_sleep();

  // Deeds of the policy.
  void carry_out_deeds();
  void carry_out(const PoolPolicy::Open& deed);
  void carry_out(const PoolPolicy::Run& deed);
  void carry_out(const PoolPolicy::Close& deed);
  void carry_out(const PoolPolicy::Warn& deed);
  void start(Worker& worker, MariaDBConnection::Outcome task);

  // Resume the tasks whose sockets are ready or whose time is over.
  void ready(Worker& worker, short events);
  void late();
  void go_on(Worker& worker, short events);
  void conclude(Worker& worker);
  void end();
  void drop_copy();

  const std::shared_ptr<const MariaDBOptions> options_;
  const Tell tell_;
  const Log log_;
  std::promise<Expected<void>> first_;
  bool first_told_ = false;

  // Guards the members up to over_.
  std::mutex mutex_;
  std::vector<Submitted> inbox_;
  // Orders without an outcome.
  std::size_t pending_ = 0;
  // The loop waits, and an order could be started now.
  bool wants_waking_ = false;
  bool over_ = false;

  const std::unique_ptr<Loop> loop_;

  // Used on the loop's thread only. There is one worker for each connection
  // that the options allow, connected or not.
  PoolPolicy policy_;
  std::vector<std::unique_ptr<Worker>> workers_;
  // Swapped with inbox_. Kept as a member to reuse its memory.
  std::vector<Submitted> taken_;
  Alarm alarm_;
  bool turn_is_due_ = false;
};

} // namespace parlour::adapters
