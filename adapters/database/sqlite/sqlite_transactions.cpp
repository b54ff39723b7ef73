#include "adapters/database/sqlite/sqlite_transactions.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters {

namespace {

// Bounds the memory; a message beyond it fails at once with kind Limit.
constexpr std::size_t max_waiting = 1'000;

} // namespace

SQLiteTransactions::Ticket SQLiteTransactions::hold(const SessionId& session) {
  holder_ = session;
  return ticket_ = ++last_ticket_;
}

void SQLiteTransactions::release() {
  holder_.reset();
}

void SQLiteTransactions::take_away() {
  if (holder_)
    lost_.add(*holder_);
  holder_.reset();
}

bool SQLiteTransactions::lost_by(const SessionId& session) const {
  return lost_.has(session);
}

void SQLiteTransactions::forget_loss(const SessionId& session) {
  lost_.forget(session);
}

// Tickets of transactions and of waiting messages come from the same counter,
// so that no number occurs twice.
std::optional<SQLiteTransactions::Ticket>
SQLiteTransactions::wait(const Message& message) {
  if (waiting_.size() >= max_waiting)
    return {};
  waiting_.push_back({++last_ticket_, message});
  return last_ticket_;
}

std::optional<SQLiteTransactions::Waiting> SQLiteTransactions::next() {
  if (waiting_.empty())
    return {};
  auto first = std::move(waiting_.front());
  waiting_.pop_front();
  return first;
}

// The message may have been handled already; its timer was late then.
std::optional<Message> SQLiteTransactions::leave(Ticket ticket) {
  const auto found = std::find_if(
      waiting_.begin(), waiting_.end(),
      [&](const Waiting& waiting) { return waiting.ticket == ticket; });
  if (found == waiting_.end())
    return {};
  auto message = std::move(found->message);
  waiting_.erase(found);
  return message;
}

} // namespace parlour::adapters
