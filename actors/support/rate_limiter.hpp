// RateLimiter: what a component may say by itself. One that floods the node
// with events runs out of it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "runtime/base/clock.hpp"

namespace parlour::actors {

// A bucket of events, filled as time passes and by each message that the
// component is given; full at first. For one thread at a time.
class RateLimiter {
public:
  // Audio in pieces of 10 ms is 100 events a second.
  static constexpr std::int64_t capacity = 2'000;
  static constexpr std::int64_t each_second = 1'000;
  // An answer in pieces, such as a page of text that is spoken, has room in
  // that.
  static constexpr std::int64_t each_message = 20;

  // False where there is none left.
  bool spend(Timestamp now) {
    refill(now);
    return left_ > 0 && left_-- > 0;
  }
  void earn() {
    left_ = std::min(capacity, left_ + each_message);
  }

private:
  // At the first call all time since 0 seems to have passed; more than the
  // capacity never counts.
  void refill(Timestamp now) {
    const auto grown = (now - filled_) * each_second / 1'000;
    if (grown <= 0)
      return;
    left_ = std::min(capacity, left_ + std::min(grown, capacity));
    filled_ = now;
  }

  std::int64_t left_ = capacity;
  Timestamp filled_ = 0;
};

} // namespace parlour::actors
