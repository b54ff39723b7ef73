#include "actors/sessions/timer.hpp"

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

timer_actor::behavior_type
timer(timer_actor::stateful_pointer<timer_state> self, NodeTime* time,
      MessageBus* bus, session_actor session, TimerOrder order) {
  self->state = {DueTicket(time->due_times, order.due),
                 time,
                 bus,
                 std::move(session),
                 order.id,
                 time->now() + order.after.count()};
  if (order.after > Milliseconds::zero())
    self->delayed_send(self, order.after, timer_expired{});
  else
    self->send(self, timer_expired{});
  return traced<timer_actor::behavior_type>(
      std::move(order.trace),
      [=](const timer_expired&) {
        auto& state = self->state;
        // The session's work begins before the due time goes with this actor.
        state.bus->ring(state.session, {state.id, state.time->work.begin()});
        self->quit();
      },
      [=](const cancel_timer&) { self->quit(); },
      [=](const get_status& what) {
        const auto& state = self->state;
        return tell_status(self, what,
                           {std::to_string(state.id),
                            "rings in " +
                                std::to_string(state.due - state.time->now()) +
                                " ms"});
      });
}

} // namespace parlour::actors
