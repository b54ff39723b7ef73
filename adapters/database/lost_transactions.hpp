// LostTransactions remembers the sessions whose transaction the database rolled
// back by itself: it took too long, its connection was lost, or the server
// chose it to resolve a deadlock. The next statement of such a session must
// fail, since it would otherwise run outside of the transaction that its script
// believes in.
//
// A session that never asks again is never removed, so only the latest 1,000
// are kept. Not thread-safe. `has` and `forget` are linear in the number of
// sessions.
#pragma once

#include <deque>

#include "runtime/message/message.hpp"

namespace parlour::adapters {

class LostTransactions {
public:
  // Adds the session, or makes it the newest one if it is already there.
  void add(const SessionId& session);
  bool has(const SessionId& session) const;
  // Removes the session: it has been told, or it begins a new transaction.
  void forget(const SessionId& session);

private:
  std::deque<SessionId> sessions_;
};

} // namespace parlour::adapters
