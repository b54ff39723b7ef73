#include "adapters/database/mariadb/pool_policy.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace parlour::adapters {

namespace {

using Kind = DatabaseCommand;

// The error for an order whose outcome is unknown.
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

// Whether nobody knows what an order did that the server did not answer. A
// lost transaction is rolled back; only the commit itself can be in doubt.
bool may_have_changed_something(const DatabaseOrder& order,
                                bool in_transaction) {
  return order.kind == Kind::commit || (order.write && !in_transaction);
}

bool can_be_repeated(const DatabaseOrder& order, bool in_transaction) {
  return order.kind == Kind::connect || order.kind == Kind::begin ||
         (order.kind == Kind::query && !in_transaction);
}

} // namespace

PoolPolicy::PoolPolicy(Limits limits)
    : limits_(limits), connections_(limits.connections) {}

// -- what happens -------------------------------------------------------------

void PoolPolicy::begin() {
  open(0);
}

void PoolPolicy::queue(DatabaseOrder order, Moment deadline) {
  queue_.push_back({std::move(order), deadline});
}

void PoolPolicy::opened(Place place, const StatementOutcome& outcome,
                        Moment now) {
  if (!outcome) {
    trouble_ = outcome.error();
    next_attempt_ = now + backoff_.after_failure();
    return close(place);
  }
  connections_[place].phase = Phase::idle;
  set_up_ = true;
  backoff_.reset();
  trouble_.reset();
}

void PoolPolicy::ended(Place place, StatementOutcome outcome,
                       const State& state, Moment now) {
  auto& connection = connections_[place];
  connection.phase = Phase::idle;
  connection.access = state.access;
  auto waiting = *std::exchange(connection.waiting, {});
  if (!outcome)
    return failed(place, std::move(waiting), outcome.error(), now, state);
  succeeded(connection, waiting.order.kind, now);
  tell(std::move(waiting), std::move(outcome));
}

void PoolPolicy::succeeded(Connection& connection, DatabaseCommand kind,
                           Moment now) {
  if (kind == Kind::begin) {
    connection.transaction_ends = now + limits_.transaction_timeout;
  } else if (kind == Kind::commit || kind == Kind::rollback) {
    connection.session.reset();
    connection.transaction_ends = Moment::max();
  }
}

void PoolPolicy::failed(Place place, Waiting waiting, const Error& error,
                        Moment now, const State& state) {
  const auto kind = waiting.order.kind;
  if (state.lost)
    return lose(place, std::move(waiting), error, now, state.in_doubt);
  // A failed Begin, Commit or Rollback leaves an unknown state. Closing the
  // connection is a rollback that cannot fail.
  if (kind != Kind::query && kind != Kind::connect)
    close(place);
  else if (connections_[place].session && state.ended_transaction)
    take_away(place);
  tell(std::move(waiting), tl::make_unexpected(error));
}

void PoolPolicy::lose(Place place, Waiting waiting, const Error& error,
                      Moment now, bool in_doubt) {
  const auto& order = waiting.order;
  const bool in_transaction = connections_[place].session.has_value();
  // A query leaves a mark for its session, whose script does not know yet that
  // the transaction has ended. The others report the end themselves.
  order.kind == Kind::query ? take_away(place) : close(place);
  if (in_doubt && may_have_changed_something(order, in_transaction)) {
    auto doubt = adapters::in_doubt(order, error.message);
    return tell(std::move(waiting), tl::make_unexpected(std::move(doubt)));
  }
  // A restarted server breaks all connections, but the pool notices it one by
  // one. So an order may fail on each of them, and once more on a new one. A
  // timeout is not repeated: the next attempt would take as long.
  if (!can_be_repeated(order, in_transaction) ||
      ++waiting.deaths > limits_.connections ||
      error.kind == ErrorKind::timeout)
    return tell(std::move(waiting), tl::make_unexpected(error));
  waiting.deadline = now + limits_.busy_timeout;
  queue_.push_front(std::move(waiting));
}

void PoolPolicy::hung_up(Place place) {
  take_away(place);
}

void PoolPolicy::close(Place place) {
  deeds_.emplace_back(Close{place});
  connections_[place] = {};
}

// Closes the connection, and marks the transaction of its session as lost.
void PoolPolicy::take_away(Place place) {
  if (const auto& session = connections_[place].session)
    lost_.add(*session);
  close(place);
}

void PoolPolicy::tell(Waiting&& waiting, StatementOutcome outcome) {
  answers_.push_back({std::move(waiting.order.message), std::move(outcome)});
}

// What runs and changes something is in doubt, by the same rule as in lose().
void PoolPolicy::end() {
  for (Place place = 0; place < connections_.size(); ++place) {
    auto& connection = connections_[place];
    if (auto waiting = std::exchange(connection.waiting, {})) {
      const auto& order = waiting->order;
      auto error =
          may_have_changed_something(order, connection.session.has_value())
              ? in_doubt(order, database_closed().message)
              : database_closed();
      tell(std::move(*waiting), tl::make_unexpected(std::move(error)));
    }
    if (connection.phase != Phase::closed)
      close(place);
  }
  for (auto& one : std::exchange(queue_, {}))
    tell(std::move(one), tl::make_unexpected(database_closed()));
}

// -- decisions ----------------------------------------------------------------

void PoolPolicy::decide(Moment now) {
  end_transactions(now);
  expire(now);
  assign();
  open_if_needed(now);
}

// A transaction is not timed while one of its statements runs.
void PoolPolicy::end_transactions(Moment now) {
  for (Place place = 0; place < connections_.size(); ++place) {
    const auto& connection = connections_[place];
    if (connection.phase != Phase::idle || connection.transaction_ends > now)
      continue;
    take_away(place);
    deeds_.emplace_back(
        Warn{"A transaction was open for too long and was rolled back."});
  }
}

// An order may wait for its own session's connection as long as it takes.
void PoolPolicy::expire(Moment now) {
  std::erase_if(queue_, [&](Waiting& one) {
    if (one.deadline > now || holder(one.order.message.session))
      return false;
    tell(std::move(one), tl::make_unexpected(why_it_waited()));
    return true;
  });
}

// Each order of the queue is looked at once. Those that cannot start keep
// their places.
void PoolPolicy::assign() {
  std::deque<Waiting> rest;
  for (; !queue_.empty() && !is_busy(); queue_.pop_front())
    if (!assign(queue_.front()))
      rest.push_back(std::move(queue_.front()));
  queue_.insert(queue_.begin(), std::make_move_iterator(rest.begin()),
                std::make_move_iterator(rest.end()));
}

// Starts the order or fails it. False if it has to wait.
bool PoolPolicy::assign(Waiting& waiting) {
  const auto& order = waiting.order;
  const auto& session = order.message.session;
  if (auto error = objection(order)) {
    tell(std::move(waiting), tl::make_unexpected(std::move(*error)));
    return true;
  }
  auto place = holder(session);
  if (!place)
    place = free_place(order.write ? Access::write : Access::read);
  if (!place || connections_[*place].phase != Phase::idle)
    return false;
  auto& connection = connections_[*place];
  connection.phase = Phase::running;
  // The connection belongs to the session from now on, so that a second order
  // of the session waits for it.
  if (order.kind == Kind::begin)
    connection.session = session;
  connection.waiting = std::move(waiting);
  deeds_.emplace_back(Run{*place});
  return true;
}

// Checks the order of Begin, Commit and Rollback. A session whose transaction
// was lost fails with each query until it ends the transaction or begins a new
// one.
std::optional<Error> PoolPolicy::objection(const DatabaseOrder& order) {
  const auto& [kind, message, write] = order;
  const auto& session = message.session;
  const bool ends = kind == Kind::commit || kind == Kind::rollback;
  if (kind == Kind::begin) {
    lost_.forget(session);
    if (holder(session))
      return already_begun();
  } else if (lost_.has(session) && (ends || kind == Kind::query)) {
    if (ends)
      lost_.forget(session);
    return rolled_back(message);
  } else if (ends && !holder(session)) {
    return not_begun(message);
  }
  return {};
}

// Opens at most one connection at a time, not before next_attempt_.
void PoolPolicy::open_if_needed(Moment now) {
  open_at_ = Moment::max();
  const auto place = place_in(Phase::closed);
  if (!place || place_in(Phase::opening) || !somebody_needs_one())
    return;
  if (now < next_attempt_)
    open_at_ = next_attempt_;
  else
    open(*place);
}

void PoolPolicy::open(Place place) {
  connections_[place].phase = Phase::opening;
  deeds_.emplace_back(Open{place, !set_up_});
}

// -- questions ----------------------------------------------------------------

std::vector<PoolPolicy::Deed> PoolPolicy::deeds() {
  return std::exchange(deeds_, {});
}

std::vector<PoolPolicy::Answer> PoolPolicy::answers() {
  return std::exchange(answers_, {});
}

const DatabaseOrder& PoolPolicy::order(Place place) const {
  return connections_[place].waiting->order;
}

bool PoolPolicy::is_busy() const {
  return !place_in(Phase::idle) && !place_in(Phase::closed);
}

PoolPolicy::Moment PoolPolicy::next_moment(Moment now) const {
  auto moment = open_at_;
  for (const auto& connection : connections_)
    if (connection.phase == Phase::idle)
      moment = std::min(moment, connection.transaction_ends);
  for (const auto& one : queue_)
    if (one.deadline < moment && !holder(one.order.message.session))
      moment = one.deadline;
  return is_busy() ? std::min(moment, now + limits_.busy_timeout) : moment;
}

std::optional<PoolPolicy::Place>
PoolPolicy::holder(const SessionId& session) const {
  for (Place place = 0; place < connections_.size(); ++place)
    if (connections_[place].session == session)
      return place;
  return {};
}

// Prefers an idle connection that is in the right access mode already.
std::optional<PoolPolicy::Place> PoolPolicy::free_place(Access access) const {
  std::optional<Place> found;
  for (Place place = 0; place < connections_.size(); ++place) {
    const auto& connection = connections_[place];
    if (connection.phase == Phase::idle && !connection.session &&
        (!found || connection.access == access))
      found = place;
  }
  return found;
}

std::optional<PoolPolicy::Place> PoolPolicy::place_in(Phase phase) const {
  for (Place place = 0; place < connections_.size(); ++place)
    if (connections_[place].phase == phase)
      return place;
  return {};
}

bool PoolPolicy::is_connected() const {
  return place_in(Phase::idle) || place_in(Phase::running);
}

// Orders of a session in a transaction wait for that session's connection.
bool PoolPolicy::somebody_needs_one() const {
  return std::any_of(queue_.begin(), queue_.end(), [this](const auto& one) {
    return !holder(one.order.message.session);
  });
}

// Distinguishes a server that cannot be reached, one that is slow to accept the
// connection, and a pool that is too small.
Error PoolPolicy::why_it_waited() const {
  if (trouble_ && !is_connected())
    return {trouble_->kind,
            "The database server cannot be reached: " + trouble_->message +
                " It is tried again and again; look whether the server runs "
                "and what the settings say of host, port and socket.",
            trouble_->place};
  if (!is_connected())
    return {ErrorKind::timeout,
            "The database server has not answered yet; it is tried again.",
            {}};
  return {ErrorKind::timeout,
          "All connections to the database are busy; the option 'connections' "
          "says how many there may be.",
          {}};
}

} // namespace parlour::adapters
