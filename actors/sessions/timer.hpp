// A timer of a session: expires once by timer_due, or is cancelled; then it
// quits. The conversation starts another for a timer that repeats.
#pragma once

#include "actors/protocol/interfaces.hpp"
#include "actors/routing/message_bus.hpp"
#include "actors/support/actor_trace.hpp"
#include "actors/support/node_time.hpp"

namespace parlour::actors {

// What SessionPort::start_timer hands over; `due` is in NodeTime already.
struct TimerOrder {
  std::uint64_t id = 0; // what the session calls it
  Milliseconds after{0};
  DueTimes::Id due = 0;
  ActorTrace trace = {};
};

// All that it has: its handlers, of which each timer has its own, keep nothing.
struct timer_state {
  static inline const char* name = "timer";
  DueTicket ticket;
  NodeTime* time = nullptr;
  MessageBus* bus = nullptr;
  session_actor session;
  std::uint64_t id = 0;
  Timestamp due = 0;
};

timer_actor::behavior_type
timer(timer_actor::stateful_pointer<timer_state> self, NodeTime* time,
      MessageBus* bus, session_actor session, TimerOrder order);

} // namespace parlour::actors
