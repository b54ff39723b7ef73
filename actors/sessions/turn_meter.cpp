#include "actors/sessions/turn_meter.hpp"

#include <algorithm>
#include <utility>

#include "runtime/message/typed_turn.hpp"

namespace parlour::actors {

// Lines without a number are turns of their own only where no line of the row
// has one. Most messages are no turns: neither table nor time is read for them.
bool TurnMeter::take(const std::vector<Message>& messages,
                     const MessageBus& bus, Nanoseconds arrived) {
  std::uint64_t lines = 0;
  std::uint64_t numbered = 0;
  for (const auto& message : messages) {
    const auto number = number_of_turn(message);
    numbered_taken_ = std::max(numbered_taken_, number);
    if (number != 0)
      ++numbered;
    else if (message.command == "RecognitionResult" &&
             bus.table()->begins_turn(message))
      ++lines;
  }
  if (lines == 0 && numbered == 0)
    return false;
  take(lines, numbered, numbered_taken_,
       arrived != 0 ? arrived : NodeMetrics::now());
  return true;
}

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

std::uint64_t TurnMeter::take_done() {
  const auto before = std::exchange(numbered_done_, numbered_taken_);
  return before == numbered_done_ ? 0 : numbered_done_;
}

} // namespace parlour::actors
