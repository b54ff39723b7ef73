#include "adapters/http/policy/retry_policy.hpp"

#include <algorithm>

namespace parlour::adapters::http {

namespace {

// Nobody can have carried it out.
bool cannot_have_arrived(const TryOutcome& outcome) {
  return !outcome && !outcome.error().was_sent;
}

// 429: too many requests.
bool may_become_better(const TryOutcome& outcome) {
  return is_trouble(outcome) || (outcome && outcome->status == 429);
}

// At least half of the pause, so that no client is at once.
Milliseconds spread(Milliseconds pause, double chance) {
  const auto half = pause / 2;
  return half + Milliseconds(static_cast<Milliseconds::rep>(
                    static_cast<double>(half.count()) * chance));
}

} // namespace

bool is_trouble(const TryOutcome& outcome) {
  using Kind = HttpFailure::Kind;
  if (outcome)
    return outcome->status == 500 || outcome->status == 502 ||
           outcome->status == 503 || outcome->status == 504;
  const auto kind = outcome.error().kind;
  return kind == Kind::unreachable || kind == Kind::late ||
         kind == Kind::broken_off || kind == Kind::not_http;
}

// 200, 400, 800 ms and so on, each shortened by chance to half at most. A pause
// behind the deadline would only delay the failure.
std::optional<Milliseconds>
pause_before_retry(const RetryTerms& terms, const HttpRequest& request,
                   const TryOutcome& outcome, unsigned tries,
                   Milliseconds remaining, double chance) {
  if (!may_become_better(outcome) || tries > terms.retries)
    return std::nullopt;
  if (!request.may_repeat && !cannot_have_arrived(outcome))
    return std::nullopt;
  auto longest = terms.pause;
  for (unsigned i = 1; i < tries && longest < terms.longest_pause; ++i)
    longest *= 2;
  auto pause = spread(std::min(longest, terms.longest_pause), chance);
  if (outcome && outcome->retry_after)
    pause = std::max(pause, *outcome->retry_after);
  if (pause >= remaining)
    return std::nullopt;
  return pause;
}

} // namespace parlour::adapters::http
