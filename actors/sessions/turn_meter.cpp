#include "actors/sessions/turn_meter.hpp"

#include <algorithm>
#include <utility>

namespace parlour::actors {

// The time counts from the first turn that has no answer yet: turns that came
// while it was worked for are answered with it.
void TurnMeter::take(std::uint64_t lines, std::uint64_t numbered,
                     std::uint64_t highest, Nanoseconds arrived) {
  const auto turns = numbered == 0 ? lines : numbered;
  if (turns == 0)
    return;
  number_ = numbered == 0 ? number_ + turns : std::max(number_, highest);
  if (open_.turns == 0)
    open_.since = arrived;
  open_.turns += turns;
}

TurnMeter::Answered TurnMeter::take_answered() {
  return std::exchange(open_, {});
}

} // namespace parlour::actors
