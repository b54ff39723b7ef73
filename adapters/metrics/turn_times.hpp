// TurnTimes: when what happened in a spoken turn, from the user's last sound to
// the robot's first. Times are those of whoever tells them; no clock.
#pragma once

#include <cstdint>
#include <optional>

#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

class TurnTimes {
public:
  // The turn was held to be over now, so long after the last sound. What is
  // known of an earlier turn is forgotten.
  void ended(Timestamp now, Milliseconds silence);
  // Each counts the first time only, and after the end of a turn.
  void recognised(Timestamp now);
  void understood(Timestamp now);
  // The robot has words for an answer, which is this utterance.
  void said(Timestamp now, std::int64_t utterance);
  // The utterance sounds. If it is the answer, all times of the turn: a map of
  // speech_end, in ms since 1970, and decided, recognised, understood, said and
  // first_sound, in ms since then; unknown where it did not happen.
  std::optional<Map> sounded(Timestamp now, std::int64_t utterance);

private:
  struct Turn {
    Timestamp speech_end = 0;
    Timestamp decided = 0;
    std::optional<Timestamp> recognised;
    std::optional<Timestamp> understood;
    std::optional<Timestamp> said;
    std::int64_t utterance = 0;
  };

  std::optional<Turn> turn_; // that is not answered yet
};

} // namespace parlour::adapters
