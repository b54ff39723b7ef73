#include "actors/sessions/timer.hpp"

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

timer_actor::behavior_type
timer(timer_actor::stateful_pointer<timer_state> self, NodeTime* time,
      MessageBus* bus, session_actor session, TimerOrder order) {
  self->state.ticket = DueTicket(time->due_times, order.due);
  if (order.after > Milliseconds::zero())
    self->delayed_send(self, order.after, timer_expired{});
  else
    self->send(self, timer_expired{});
  return traced<timer_actor::behavior_type>(
      order.trace,
      [=](const timer_expired&) {
        // The session's work begins before the due time goes with this actor.
        bus->ring(session, {order.id, time->work.begin()});
        self->quit();
      },
      [=](const cancel_timer&) { self->quit(); },
      [=, due = time->now() + order.after.count()](const get_status& what) {
        return tell_status(
            self, what,
            {std::to_string(order.id),
             "rings in " + std::to_string(due - time->now()) + " ms"});
      });
}

} // namespace parlour::actors
