// Apologies: how often the robot says that something went wrong. However much
// fails, once is enough, until the user has spoken again or a while has passed:
// twice as long each time that nobody has.
#pragma once

#include <algorithm>

#include "runtime/base/clock.hpp"

namespace parlour::dialogue {

class Apologies {
public:
  void user_speaks() {
    pause_ = Milliseconds::zero();
    next_ = 0;
  }
  // Whether one is due now; then it counts as made.
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

  Milliseconds pause_{0};
  Timestamp next_ = 0;
};

} // namespace parlour::dialogue
