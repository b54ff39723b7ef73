#include "actors/routing/reply_registry.hpp"

#include <utility>

namespace parlour::actors {

Correlation ReplyRegistry::add(query_actor query, Wants wants) {
  std::lock_guard lock(mutex_);
  waiting_[++last_] = {std::move(query), wants};
  return last_;
}

// Each event passes here, most of them for nobody here.
query_actor ReplyRegistry::take(Correlation correlation) {
  std::lock_guard lock(mutex_);
  auto found = waiting_.find(correlation);
  if (found == waiting_.end())
    return {};
  auto query = found->second.query;
  if (found->second.wants == Wants::the_first)
    waiting_.erase(found);
  return query;
}

void ReplyRegistry::forget(Correlation correlation) {
  std::lock_guard lock(mutex_);
  waiting_.erase(correlation);
}

} // namespace parlour::actors
