#include "adapters/http/policy/exchange.hpp"

#include <algorithm>
#include <utility>

#include "adapters/http/policy/redirect_policy.hpp"

namespace parlour::adapters::http {

Exchange::Exchange(HttpRequest request, Terms terms, Moment deadline)
    : request_(std::move(request)), terms_(terms), deadline_(deadline) {}

Milliseconds Exchange::remaining(Moment now) const {
  return std::max(std::chrono::duration_cast<Milliseconds>(deadline_ - now),
                  Milliseconds::zero());
}

std::variant<Exchange::Again, Exchange::Done>
Exchange::after(TryOutcome outcome, Moment now, double chance) {
  ++tries_;
  if (outcome && is_redirect(*outcome))
    return follow(*outcome);
  if (const auto pause = pause_before_retry(terms_.retry, request_, outcome,
                                            tries_, remaining(now), chance))
    return Again{*pause};
  return Done{std::move(outcome)};
}

// A redirect is no failed try, and has a limit of its own.
std::variant<Exchange::Again, Exchange::Done>
Exchange::follow(const HttpAnswer& answer) {
  using Kind = HttpFailure::Kind;
  if (++redirects_ > terms_.redirects)
    return Done{tl::make_unexpected(HttpFailure{
        Kind::refused,
        "redirects more than " + std::to_string(terms_.redirects) + " times",
        true})};
  auto next = redirected(request_, answer);
  if (!next)
    return Done{
        tl::make_unexpected(HttpFailure{Kind::refused, next.error(), true})};
  request_ = std::move(*next);
  --tries_;
  return Again{};
}

} // namespace parlour::adapters::http
