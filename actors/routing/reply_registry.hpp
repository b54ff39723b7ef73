// ReplyRegistry: which query actor waits for which answer. A query gets a
// correlation for the message that it sends; the message centre gives it the
// event with this correlation: the first one, or each until it is
// forgotten.
#pragma once

#include <map>
#include <mutex>

#include "actors/protocol/interfaces.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// Queries and asks add themselves on their own threads and forget their entry
// when they end; the message centre takes.
class ReplyRegistry {
public:
  // A correlation that no session gives out itself: those count from 1, ours
  // have the highest bit set.
  enum class Wants { the_first, all };
  Correlation add(query_actor query, Wants wants = Wants::the_first);
  // Null where nobody waits for it (any more).
  // With Wants::the_first the entry is gone afterwards: a second answer goes to
  // the session that the event names.
  query_actor take(Correlation correlation);
  void forget(Correlation correlation);

private:
  struct Waiting {
    query_actor query;
    Wants wants;
  };

  std::mutex mutex_;
  std::map<Correlation, Waiting> waiting_;
  Correlation last_ = Correlation{1} << 63;
};

} // namespace parlour::actors
