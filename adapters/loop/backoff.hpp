// Backoff: how long to pause before the next attempt of something that has
// failed: each time twice as long, up to a bound. No clock, no thread.
#pragma once

#include <algorithm>
#include <utility>

#include "runtime/base/clock.hpp"

namespace parlour::adapters {

class Backoff {
public:
  Backoff(Milliseconds first, Milliseconds longest)
      : first_(first), longest_(longest), next_(first) {}

  // The pause after this failure.
  Milliseconds after_failure() {
    return std::exchange(next_, std::min(2 * next_, longest_));
  }
  // It has succeeded: the next failure is the first again.
  void reset() {
    next_ = first_;
  }

private:
  Milliseconds first_;
  Milliseconds longest_;
  Milliseconds next_;
};

} // namespace parlour::adapters
