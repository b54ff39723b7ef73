// TurnMeter: the number of the user's turn that a session has taken last, and
// since when turns wait for their answers. Lives on the session's thread.
#pragma once

#include <cstdint>
#include <vector>

#include "actors/routing/message_bus.hpp"
#include "runtime/base/metrics.hpp"
#include "runtime/message/message.hpp"

namespace parlour::actors {

// For the metric `parlour_turn_seconds` and the number that inspections show. A
// row of three lines is three turns; one numbered turn of three lines is one.
class TurnMeter {
public:
  // One that goes on after a crash.
  void go_on(std::uint64_t taken) {
    number_ = numbered_taken_ = taken;
  }
  // What came together, at that time, or just now (0); `bus` knows what a
  // recogniser is. False where no turn of a user is in it.
  bool take(const std::vector<Message>& messages, const MessageBus& bus,
            Nanoseconds arrived);
  // Lines of the user that came together. Lines without a number belong to the
  // turn of the one that has one.
  void take(std::uint64_t lines, std::uint64_t numbered, std::uint64_t highest,
            Nanoseconds arrived);
  std::uint64_t number() const {
    return number_;
  }

  // Turns that are answered now, and when the first of them came.
  struct Answered {
    std::uint64_t turns = 0;
    Nanoseconds since = 0;
  };
  // Called when the session has nothing left to do for them; none are open
  // afterwards.
  Answered take_answered();
  // The highest number of a turn that was taken since the last call, which is
  // answered now; 0: none had one.
  std::uint64_t take_done();

private:
  std::uint64_t number_ = 0;
  // As whoever numbers turns knows them.
  std::uint64_t numbered_taken_ = 0;
  std::uint64_t numbered_done_ = 0;
  Answered open_;
};

} // namespace parlour::actors
