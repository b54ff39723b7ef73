// Which sessions have lost the transaction that they were in and have not been
// told yet. Of the latest only, as sessions may never ask.
#pragma once

#include <deque>

#include "runtime/base/message.hpp"

namespace parlour::adapters {

class LostTransactions {
public:
  void add(const SessionId& session);
  bool has(const SessionId& session) const;
  void forget(const SessionId& session);

private:
  std::deque<SessionId> sessions_;
};

} // namespace parlour::adapters
