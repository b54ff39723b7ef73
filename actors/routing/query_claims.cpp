#include "actors/routing/query_claims.hpp"

#include <utility>

namespace parlour::actors {

Correlation QueryClaims::claim(query_actor query, Wants wants) {
  std::lock_guard lock(mutex_);
  claims_[++last_] = {std::move(query), wants};
  return last_;
}

query_actor QueryClaims::take(Correlation correlation) {
  std::lock_guard lock(mutex_);
  auto claim = claims_.find(correlation);
  if (claim == claims_.end())
    return {};
  auto query = claim->second.query;
  if (claim->second.wants == Wants::the_first)
    claims_.erase(claim);
  return query;
}

void QueryClaims::forget(Correlation correlation) {
  std::lock_guard lock(mutex_);
  claims_.erase(correlation);
}

} // namespace parlour::actors
