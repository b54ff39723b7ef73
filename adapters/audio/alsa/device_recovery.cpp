#include "adapters/audio/alsa/device_recovery.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters {

namespace {

// `first`, doubled so many times, but not more than `longest`.
Milliseconds doubled(Milliseconds first, int times, Milliseconds longest) {
  auto pause = first;
  for (; times > 0 && pause < longest; --times)
    pause *= 2;
  return std::min(pause, longest);
}

} // namespace

DeviceRecovery::DeviceRecovery(RecoveryLimits limits) : limits_(limits) {}

std::optional<Milliseconds> DeviceRecovery::glitch(Moment) {
  works_since_.reset();
  if (++glitches_ > limits_.glitches)
    return std::nullopt;
  if (glitches_ == 1)
    return Milliseconds::zero();
  return doubled(limits_.glitch_pause, glitches_ - 2,
                 limits_.longest_glitch_pause);
}

// A device that has just been opened may have as many glitches as before.
Milliseconds DeviceRecovery::broken(Moment now) {
  works_since_.reset();
  glitches_ = 0;
  if (!broken_since_)
    broken_since_ = now;
  return doubled(limits_.open_pause, attempts_++, limits_.longest_open_pause);
}

bool DeviceRecovery::must_report(Moment now) {
  if (reported_ || !broken_since_ ||
      now - *broken_since_ < limits_.report_after)
    return false;
  return reported_ = true;
}

bool DeviceRecovery::works(Moment now) {
  if (!works_since_)
    works_since_ = now;
  if (now - *works_since_ < limits_.stable_after)
    return false;
  glitches_ = 0;
  attempts_ = 0;
  broken_since_.reset();
  return std::exchange(reported_, false);
}

} // namespace parlour::adapters
