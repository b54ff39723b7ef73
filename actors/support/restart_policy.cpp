#include "actors/support/restart_policy.hpp"

#include <algorithm>

namespace parlour::actors {

// `recent_` holds the failures of the last minute, the oldest first.
// A component that has worked for a minute after its return begins anew: its
// next five failures lead to the first, short time down.
RestartPolicy::Verdict RestartPolicy::failed(Timestamp now) {
  ++count_;
  const bool returned =
      down_time_ > Milliseconds::zero() && now < returns_ + window.count();
  if (returned)
    return go_down(now);
  while (!recent_.empty() && recent_.front() <= now - window.count())
    recent_.pop_front();
  recent_.push_back(now);
  if (recent_.size() >= max_failures) {
    down_time_ = Milliseconds::zero();
    return go_down(now);
  }
  const auto before = recent_.size() - 1;
  return {false, before == 0 ? Milliseconds::zero()
                             : first_pause * (1 << (before - 1))};
}

// The failures before it was down do not count afterwards; that it was down
// does.
RestartPolicy::Verdict RestartPolicy::go_down(Timestamp now) {
  recent_.clear();
  down_time_ = down_time_ == Milliseconds::zero()
                   ? first_down_time
                   : std::min(down_time_ * 2, max_down_time);
  returns_ = now + down_time_.count();
  return {true, down_time_};
}

} // namespace parlour::actors
