#include "actors/sessions/timer.hpp"

#include <caf/typed_event_based_actor.hpp>

namespace parlour::actors {

timer_actor::behavior_type
timer(timer_actor::stateful_pointer<timer_state> self, NodeTime* time,
      session_actor session, TimerOrder order) {
  self->state.ticket = DueTicket(time->due_times, order.due);
  if (order.after > Milliseconds::zero())
    self->delayed_send(self, order.after, ring{});
  else
    self->send(self, ring{});
  return {
      [=](const ring&) {
        // The session's work begins before the due time goes with this actor.
        self->send(session, timer_due{order.id, time->work.begin()});
        self->quit();
      },
      [=](const cancel_timer&) { self->quit(); },
  };
}

} // namespace parlour::actors
