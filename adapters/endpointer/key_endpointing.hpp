// KeyEndpointing: decides by a key which audio is a user's turn: it begins a
// little before the key is pressed, since people press and speak at once, and
// ends a little after the release. What is shorter than a word is no turn, but
// it interrupts the robot like any other.
//
// Time is the position in the audio, in milliseconds, as in endpointing.hpp.
// Not thread-safe.
#pragma once

#include <deque>
#include <optional>

#include "adapters/endpointer/endpointing.hpp"

namespace parlour::adapters {

struct KeyEndpointTimes {
  // How much audio before the press and after the release belongs to the turn.
  Milliseconds before{300};
  Milliseconds after{200};
  // Shorter ones are dropped, longer ones are cut.
  Milliseconds shortest{150};
  Milliseconds longest{60'000};
};

class KeyEndpointing {
public:
  explicit KeyEndpointing(KeyEndpointTimes times) : times_(times) {}

  // The next frame, which begins at this position.
  TurnSteps hear(Value frame, std::int64_t position);
  TurnSteps pressed();
  TurnSteps released();
  // No more audio comes: a turn ends as it is.
  TurnSteps finish();
  // Forgets all, and drops the turn that is open: positions begin anew.
  TurnSteps reset();

  bool in_turn() const {
    return start_.has_value();
  }

private:
  struct Frame {
    Value audio;
    std::int64_t position = 0;
  };

  void begin(TurnSteps& steps);
  void end(TurnSteps& steps);

  KeyEndpointTimes times_;
  std::deque<Frame> kept_; // of before the key is pressed
  std::int64_t now_ = 0;   // where the last frame began
  // Of the turn that is open: where the key was pressed and released.
  std::optional<std::int64_t> start_;
  std::optional<std::int64_t> release_;
};

} // namespace parlour::adapters
