#include "adapters/database/lost_transactions.hpp"

#include <algorithm>

namespace parlour::adapters {

namespace {

// Bounds the memory: a session that ended without a further statement is never
// removed by `forget`.
constexpr std::size_t max_sessions = 1'000;

} // namespace

void LostTransactions::add(const SessionId& session) {
  forget(session);
  sessions_.push_back(session);
  if (sessions_.size() > max_sessions)
    sessions_.pop_front();
}

bool LostTransactions::has(const SessionId& session) const {
  return std::find(sessions_.begin(), sessions_.end(), session) !=
         sessions_.end();
}

void LostTransactions::forget(const SessionId& session) {
  std::erase(sessions_, session);
}

} // namespace parlour::adapters
