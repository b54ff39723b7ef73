// Messages through components' mailboxes: two plug-ins that hand balls to each
// other by name, by the message centre's table; and the same by typed actors of
// CAF with nothing around them.
#pragma once

#include "runtime/base/error.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// What is measured is CPU time, not waiting. Bare actors share one thread; each
// component has its own.
struct BallGame {
  int throws = 0; // altogether
  // In the air at a time, each one session's: no session throws its ball so
  // often in a second that it is taken for a ring without end.
  int balls = 256;
};

// A throw is a message from one plug-in to the other: stamped, routed, counted.
Expected<Measured> components_play(const BallGame& game);

enum class Way : unsigned char {
  hub,   // through an actor that knows the players by their names
  direct // from player to player
};
Measured bare_actors_play(const BallGame& game, Way way);

} // namespace parlour::tools
