#include "adapters/database/mariadb/mariadb_pool.hpp"

#include <algorithm>
#include <utility>

#include "adapters/database/mariadb/mariadb_setup.hpp"

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;
using Kind = DatabaseCommand;

// The server ends a slow statement itself (max_statement_time). If it has said
// nothing this much later, it is considered gone.
constexpr Milliseconds grace{1'000};

// The task that executes an order. It is not started yet.
MariaDBConnection::Outcome task_of(MariaDBConnection& connection,
                                   const DatabaseOrder& order) {
  const auto& params = order.message.params;
  switch (order.kind) {
  case Kind::connect:
    return connection.control("do 1");
  case Kind::begin:
    return connection.begin();
  case Kind::commit:
    return connection.end(MariaDBConnection::End::commit);
  case Kind::rollback:
    return connection.end(MariaDBConnection::End::rollback);
  default:
    return connection.run(params[0], params.size() > 1 ? params[1] : Value(),
                          order.write ? Access::write : Access::read);
  }
}

} // namespace

MariaDBPool::Worker::Worker(MariaDBPool& pool, PoolPolicy::Place number)
    : place(number), watch(*pool.loop_, [this, &pool](short events) {
        pool.ready(*this, events);
      }) {}

MariaDBPool::MariaDBPool(MariaDBOptions options, std::unique_ptr<Loop> loop,
                         Tell tell, Log log)
    : options_(std::make_shared<const MariaDBOptions>(std::move(options))),
      tell_(std::move(tell)), log_(std::move(log)), loop_(std::move(loop)),
      policy_({options_->connections, options_->busy_timeout,
               options_->transaction_timeout}),
      alarm_(*loop_, [this] { late(); }) {
  for (std::size_t i = 0; i < options_->connections; ++i)
    workers_.push_back(std::make_unique<Worker>(*this, i));
  loop_->post([this] {
    policy_.begin();
    turn();
  });
}

MariaDBPool::~MariaDBPool() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  loop_->post([this] { end(); });
  loop_->stop();
}

Expected<void> MariaDBPool::first_connection() {
  return first_.get_future().get();
}

void MariaDBPool::submit(DatabaseOrder order) {
  const auto deadline = Steady::now() + options_->busy_timeout;
  {
    const std::lock_guard lock(mutex_);
    if (pending_ < PoolPolicy::max_pending) {
      ++pending_;
      inbox_.push_back({std::move(order), deadline});
      // The loop is woken up only if it can use the order.
      if (std::exchange(wants_waking_, false))
        loop_->post([this] { turn(); });
      return;
    }
  }
  tell_(order.message, fail(ErrorKind::limit, "Too many wait for the "
                                              "database."));
}

// -- on the loop's thread -----------------------------------------------------

// Outcomes are reported after the next orders have been started, so that the
// server already works on them while the outcomes are processed.
void MariaDBPool::turn() {
  turn_is_due_ = false;
  if (!take_in())
    return;
  policy_.decide(Steady::now());
  carry_out_deeds();
  hand_over();
  wait_for_events();
}

// When something has happened within a turn.
void MariaDBPool::turn_soon() {
  if (!std::exchange(turn_is_due_, true))
    loop_->post([this] { turn(); });
}

// Moves new orders into the queue. False if the pool is to end.
bool MariaDBPool::take_in() {
  bool goes_on = false;
  {
    const std::lock_guard lock(mutex_);
    goes_on = !over_;
    wants_waking_ = false;
    taken_.swap(inbox_);
  }
  for (auto& [order, deadline] : taken_)
    policy_.queue(std::move(order), deadline);
  taken_.clear();
  return goes_on;
}

void MariaDBPool::hand_over() {
  auto answers = policy_.answers();
  if (answers.empty())
    return;
  {
    const std::lock_guard lock(mutex_);
    pending_ -= answers.size();
  }
  for (auto& [message, outcome] : answers)
    tell_(message, std::move(outcome));
}

void MariaDBPool::wait_for_events() {
  auto moment = policy_.next_moment(Steady::now());
  for (const auto& worker : workers_)
    if (const auto& connection = worker->connection) {
      worker->watch.await(connection->descriptor(), connection->interest());
      moment = std::min(moment, connection->deadline());
    }
  alarm_.set(moment);
  if (!may_sleep())
    turn_soon();
}

// False if an order has arrived that could be started, or the pool is to end.
// While the policy is busy nobody wakes the loop for a new order.
bool MariaDBPool::may_sleep() {
  const bool busy = policy_.is_busy();
  const std::lock_guard lock(mutex_);
  wants_waking_ = !busy;
  return !over_ && (busy || inbox_.empty());
}

// -- deeds --------------------------------------------------------------------

// A deed may end at once, and lead to others.
void MariaDBPool::carry_out_deeds() {
  for (auto deeds = policy_.deeds(); !deeds.empty(); deeds = policy_.deeds())
    for (const auto& deed : deeds)
      std::visit([this](const auto& one) { carry_out(one); }, deed);
}

void MariaDBPool::carry_out(const PoolPolicy::Open& deed) {
  auto& worker = *workers_[deed.place];
  worker.connection = std::make_unique<MariaDBConnection>(options_);
  worker.is_opening = true;
  auto& connection = *worker.connection;
  start(worker, deed.sets_up
                    ? open_and_set_up(connection, *options_)
                    : connection.open(MariaDBConnection::To::database));
}

void MariaDBPool::carry_out(const PoolPolicy::Run& deed) {
  auto& worker = *workers_[deed.place];
  worker.connection->give_time(options_->query_timeout + grace);
  start(worker, task_of(*worker.connection, policy_.order(deed.place)));
}

// A suspended task is first resumed as if its deadline had passed until it
// ends, so that the library releases what it holds.
void MariaDBPool::carry_out(const PoolPolicy::Close& deed) {
  auto& worker = *workers_[deed.place];
  while (worker.task && !worker.task.done())
    worker.connection->go_on(0);
  worker.task = {};
  worker.is_opening = false;
  worker.watch.stop();
  worker.connection.reset();
}

void MariaDBPool::carry_out(const PoolPolicy::Warn& deed) {
  log_(std::string(deed.text));
}

void MariaDBPool::start(Worker& worker, MariaDBConnection::Outcome task) {
  worker.task = std::move(task);
  worker.task.start();
  if (!worker.task.done())
    return;
  conclude(worker);
  turn_soon();
}

// -- events -------------------------------------------------------------------

void MariaDBPool::ready(Worker& worker, short events) {
  if (worker.task)
    go_on(worker, events);
  else
    // The server speaks unasked only to close the connection.
    policy_.hung_up(worker.place);
  turn();
}

void MariaDBPool::late() {
  const auto now = Steady::now();
  for (const auto& worker : workers_)
    if (worker->task && worker->connection->deadline() <= now)
      go_on(*worker, 0);
  turn();
}

void MariaDBPool::go_on(Worker& worker, short events) {
  // While it connects, the library may close its socket and open another one.
  if (worker.is_opening)
    worker.watch.stop();
  worker.connection->go_on(events);
  if (worker.task.done())
    conclude(worker);
}

// The first outcome of all is passed to first_connection().
void MariaDBPool::conclude(Worker& worker) {
  auto outcome = worker.task.result();
  worker.task = {};
  const auto now = Steady::now();
  const auto& connection = *worker.connection;
  if (!std::exchange(worker.is_opening, false)) {
    policy_.ended(worker.place, std::move(outcome),
                  {connection.state().lost(), connection.state().in_doubt(),
                   connection.state().ended_transaction(), connection.access()},
                  now);
    return;
  }
  policy_.opened(worker.place, outcome, now);
  if (!std::exchange(first_told_, true))
    first_.set_value(outcome.map([](const auto&) {}));
}

// -- the end ------------------------------------------------------------------

// Answers everything that is left.
void MariaDBPool::end() {
  take_in();
  policy_.end();
  carry_out_deeds();
  hand_over();
  if (!first_told_)
    first_.set_value(tl::make_unexpected(database_closed()));
  if (options_->copy)
    drop_copy();
}

// A new connection, since the others may have been lost. Errors are ignored:
// nobody is left who could act on them.
void MariaDBPool::drop_copy() {
  MariaDBConnection connection(options_);
  using To = MariaDBConnection::To;
  if (!adapters::carry_out(connection, connection.open(To::server)))
    return;
  connection.give_time(options_->connect_timeout);
  (void)adapters::carry_out(connection,
                            connection.control("drop database if exists \"" +
                                               options_->database + "\""));
}

} // namespace parlour::adapters
