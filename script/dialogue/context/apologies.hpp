// Apologies: how often the robot says that something went wrong (engine rule
// 1.7). However much fails, once is enough, until the user has spoken again or
// a while has passed: twice as long each time that nobody has.
#pragma once

#include <algorithm>

#include "runtime/base/clock.hpp"

namespace parlour::dialogue {

// A part of the OutputManager.
class Apologies {
public:
  void user_speaks() {
    pause_ = Milliseconds::zero();
    next_ = 0;
  }
  // Whether one is due now; then it counts as made. The first is due at once,
  // the next after 10 s, then after 20 s, 40 s … up to an hour.
  bool due(Timestamp now) {
    if (now < next_)
      return false;
    pause_ = std::clamp(2 * pause_, shortest, longest);
    next_ = now + pause_.count();
    return true;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(pause_, next_);
  }

private:
  static constexpr Milliseconds shortest = std::chrono::seconds(10);
  static constexpr Milliseconds longest = std::chrono::hours(1);

  // How long the last apology keeps the next one back.
  Milliseconds pause_{0};
  Timestamp next_ = 0;
};

} // namespace parlour::dialogue
