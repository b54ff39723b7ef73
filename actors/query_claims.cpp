#include "actors/query_claims.hpp"

#include <utility>

namespace parlour::actors {

Correlation QueryClaims::claim(query_actor query) {
  std::lock_guard lock(mutex_);
  claims_[++last_] = std::move(query);
  return last_;
}

query_actor QueryClaims::take(Correlation correlation) {
  std::lock_guard lock(mutex_);
  auto claim = claims_.extract(correlation);
  return claim.empty() ? query_actor() : std::move(claim.mapped());
}

} // namespace parlour::actors
