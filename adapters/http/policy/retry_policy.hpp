// Whether a request is sent once more, and after which pause. No clock, no
// network.
#pragma once

#include <optional>

#include "adapters/http/message/http_message.hpp"

namespace parlour::adapters::http {

struct RetryTerms {
  // How often a request is sent again.
  unsigned retries = 2;
  // The pause before the second try; it doubles with each further one.
  Milliseconds pause{200};
  Milliseconds longest_pause{5'000};
};

// Whether the service is at fault and may soon answer better: it cannot be
// reached, breaks off, is late, or answers 500, 502, 503 or 504.
bool is_trouble(const TryOutcome& outcome);

// The pause before the next try; nothing: the outcome stands. A request that
// may not be repeated is sent again only if the service cannot have got it. The
// pause is as long as the service asks for, and never ends after `remaining`.
// `tries`: how often the request has been sent. `chance`, from 0 to 1, spreads
// the pauses of many clients, between half of a pause and the whole.
std::optional<Milliseconds>
pause_before_retry(const RetryTerms& terms, const HttpRequest& request,
                   const TryOutcome& outcome, unsigned tries,
                   Milliseconds remaining, double chance);

} // namespace parlour::adapters::http
