// QueryClaims: whose answer is this? A query actor claims the correlation of
// the message that it sent, and the message centre gives it the event that
// carries it: the first one, or each until it forgets its claim.
#pragma once

#include <map>
#include <mutex>

#include "actors/protocol/interfaces.hpp"

namespace parlour::actors {

// Safe to use from any thread.
class QueryClaims {
public:
  // A correlation that no session gives out itself: those count from 1, ours
  // have the highest bit set.
  enum class Wants { the_first, all };
  Correlation claim(query_actor query, Wants wants = Wants::the_first);
  // Null where nobody claims it (any more).
  query_actor take(Correlation correlation);
  void forget(Correlation correlation);

private:
  struct Claim {
    query_actor query;
    Wants wants;
  };

  std::mutex mutex_;
  std::map<Correlation, Claim> claims_;
  Correlation last_ = Correlation{1} << 63;
};

} // namespace parlour::actors
