// Exchange is one request from its beginning to its outcome: the tries, the
// redirects and the pauses between them. It decides and sends nothing.
#pragma once

#include <chrono>
#include <variant>

#include "adapters/http/policy/retry_policy.hpp"

namespace parlour::adapters::http {

// HttpClient sends request(), calls after() with what became of it, and does
// what that says.
class Exchange {
public:
  using Moment = std::chrono::steady_clock::time_point;

  struct Terms {
    RetryTerms retry;
    unsigned redirects = 3;
  };
  // Send request() after this pause.
  struct Again {
    Milliseconds pause{};
  };
  // This is the outcome.
  struct Done {
    TryOutcome outcome;
  };

  // `deadline`: when all must be over.
  Exchange(HttpRequest request, Terms terms, Moment deadline);

  // What is to be sent next.
  const HttpRequest& request() const {
    return request_;
  }
  Moment deadline() const {
    return deadline_;
  }
  // What is left until the deadline; never less than nothing.
  Milliseconds remaining(Moment now) const;

  // What follows the outcome of a try. `chance` is from 0 to 1.
  std::variant<Again, Done> after(TryOutcome outcome, Moment now,
                                  double chance);

private:
  std::variant<Again, Done> follow(const HttpAnswer& answer);

  HttpRequest request_;
  Terms terms_;
  Moment deadline_;
  unsigned tries_ = 0; // without those that were redirected
  unsigned redirects_ = 0;
};

} // namespace parlour::adapters::http
