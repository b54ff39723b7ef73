// RateLimit bounds how many things may happen in a second. No clock, no thread.
#pragma once

#include <chrono>

namespace parlour {

class RateLimit {
public:
  using Moment = std::chrono::steady_clock::time_point;

  // `per_second` things on average, and as many at once.
  explicit RateLimit(unsigned per_second) : RateLimit(per_second, per_second) {}
  RateLimit(unsigned per_second, unsigned at_once)
      : per_second_(per_second), at_once_(at_once), left_(at_once) {}

  // Whether one more may happen now. The moments never go back.
  bool admit(Moment now);

private:
  const double per_second_;
  const double at_once_;
  double left_;
  Moment last_{};
};

} // namespace parlour
