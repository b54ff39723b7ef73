// RateLimit bounds how many things may happen in a second. No clock, no thread.
#pragma once

#include <chrono>

namespace parlour::adapters::http {

class RateLimit {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // `per_second` things on average, and as many at once.
  explicit RateLimit(unsigned per_second)
      : per_second_(per_second), left_(per_second) {}

  // Whether one more may happen now. The moments never go back.
  bool admit(Moment now);

private:
  const double per_second_;
  double left_;
  Moment last_{};
};

} // namespace parlour::adapters::http
