// A timer of a session: rings once, or is cancelled.
#pragma once

#include "actors/protocol/interfaces.hpp"
#include "actors/support/node_time.hpp"

namespace parlour::actors {

struct timer_state {
  static inline const char* name = "timer";
  DueTicket ticket;
};

struct TimerOrder {
  std::uint64_t id = 0; // what the session calls it
  Milliseconds after{0};
  DueTimes::Id due = 0;
};

timer_actor::behavior_type
timer(timer_actor::stateful_pointer<timer_state> self, NodeTime* time,
      session_actor session, TimerOrder order);

} // namespace parlour::actors
