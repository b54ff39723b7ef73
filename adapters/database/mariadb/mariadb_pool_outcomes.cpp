// What came of the tasks of a pool's connections.
#include <algorithm>
#include <utility>

#include "adapters/database/mariadb/mariadb_pool.hpp"

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;
using Kind = DatabaseCommand;

constexpr Milliseconds first_pause{50};
constexpr Milliseconds longest_pause{5'000};

Milliseconds pause_after(unsigned failures) {
  return std::min(longest_pause, first_pause * (1 << std::min(failures, 10u)));
}

Error in_doubt(const DatabaseOrder& order, const std::string& reason) {
  const auto what = order.kind == Kind::commit
                        ? "Commit"
                        : first_words(order.message.params[0].text());
  return {ErrorKind::in_doubt,
          what +
              ": the connection was lost before the server answered, so that "
              "it may have been carried out or not; look before it is done "
              "again (" +
              reason + ")",
          {}};
}

bool changes_something(const DatabaseOrder& order) {
  return order.kind == Kind::commit || order.write;
}

} // namespace

void MariaDBPool::conclude(Worker& worker) {
  auto outcome = worker.task.result();
  worker.task = {};
  auto waiting = std::exchange(worker.waiting, {});
  if (!waiting)
    opened(worker, outcome);
  else if (outcome)
    succeeded(worker, std::move(*waiting), std::move(outcome));
  else
    failed(worker, std::move(*waiting), outcome.error());
}

void MariaDBPool::opened(Worker& worker, const StatementOutcome& outcome) {
  if (outcome) {
    set_up_ = true;
    failures_ = 0;
    trouble_.reset();
  } else {
    trouble_ = outcome.error();
    next_attempt_ = Steady::now() + pause_after(failures_++);
    drop(worker);
  }
  if (!std::exchange(first_told_, true))
    first_.set_value(outcome.map([](const auto&) {}));
}

void MariaDBPool::succeeded(Worker& worker, Waiting waiting,
                            StatementOutcome outcome) {
  const auto kind = waiting.order.kind;
  if (kind == Kind::begin) {
    worker.transaction_ends = Steady::now() + options_->transaction_timeout;
  } else if (kind == Kind::commit || kind == Kind::rollback) {
    worker.session.reset();
    worker.transaction_ends = Moment::max();
  }
  tell(std::move(waiting), std::move(outcome));
}

void MariaDBPool::failed(Worker& worker, Waiting waiting, const Error& error) {
  const auto kind = waiting.order.kind;
  if (worker.connection->lost())
    return lose(worker, std::move(waiting), error);
  // Closing the connection is the roll-back that cannot fail.
  if (kind != Kind::query && kind != Kind::connect)
    drop(worker);
  else if (worker.session && worker.connection->ended_transaction())
    take_away(worker);
  tell(std::move(waiting), tl::make_unexpected(error));
}

void MariaDBPool::lose(Worker& worker, Waiting waiting, const Error& error) {
  const auto& order = waiting.order;
  const bool doubtful = worker.connection->in_doubt() &&
                        changes_something(order) &&
                        (order.kind == Kind::commit || !worker.session);
  const bool can_be_repeated = order.kind == Kind::connect ||
                               order.kind == Kind::begin ||
                               (order.kind == Kind::query && !worker.session);
  if (order.kind == Kind::query)
    take_away(worker);
  else
    drop(worker);
  if (doubtful)
    return tell(std::move(waiting),
                tl::make_unexpected(in_doubt(order, error.message)));
  // Connections that die together may not all be known to be dead yet.
  if (!can_be_repeated || ++waiting.deaths > options_->connections ||
      error.kind == ErrorKind::timeout)
    return tell(std::move(waiting), tl::make_unexpected(error));
  waiting.deadline = Steady::now() + options_->busy_timeout;
  waiting_.push_front(std::move(waiting));
}

// A task in the middle ends as if its time were up, so that the library lets
// go of what it holds.
void MariaDBPool::drop(Worker& worker) {
  while (worker.task && !worker.task.done())
    worker.connection->go_on(0);
  worker.task = {};
  worker.connection.reset();
  worker.session.reset();
  worker.transaction_ends = Moment::max();
}

// With the transaction of whoever has one there.
void MariaDBPool::take_away(Worker& worker) {
  if (worker.session)
    lost_.add(*worker.session);
  drop(worker);
}

void MariaDBPool::tell(Waiting&& waiting, StatementOutcome outcome) {
  told_.push_back({std::move(waiting.order.message), std::move(outcome)});
}

void MariaDBPool::end() {
  take_in();
  for (auto& worker : workers_) {
    if (auto waiting = std::exchange(worker->waiting, {}))
      tell(std::move(*waiting),
           tl::make_unexpected(
               changes_something(waiting->order) &&
                       (!worker->session || waiting->order.kind == Kind::commit)
                   ? in_doubt(waiting->order, database_closed().message)
                   : database_closed()));
    drop(*worker);
  }
  for (auto& one : std::exchange(waiting_, {}))
    tell(std::move(one), tl::make_unexpected(database_closed()));
  hand_over();
  if (!first_told_)
    first_.set_value(tl::make_unexpected(database_closed()));
  if (options_->copy)
    drop_copy();
}

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
