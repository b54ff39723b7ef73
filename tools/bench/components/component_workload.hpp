// The workload of `parlour bench components`: two plug-ins throw balls to each
// other, by name and through the message centre; and the same game played by
// typed actors of CAF.
#pragma once

#include "runtime/base/error.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// CPU time is measured, so waiting costs nothing. Bare actors share one thread;
// each component has one of its own.
struct BallGame {
  // Of all balls together.
  int throws = 0;
  // Balls in the air at a time. Each belongs to its own session: messages that
  // answer each other are limited for each session (engine rule 1.6), and no
  // session reaches the limit.
  int balls = 256;
};

// A throw is a message from one plug-in to the other: stamped, routed and
// counted.
Expected<Measured> components_play(const BallGame& game);

enum class Way : unsigned char {
  hub,   // through an actor that knows the players by name
  direct // from player to player
};
Measured bare_actors_play(const BallGame& game, Way way);

} // namespace parlour::tools
