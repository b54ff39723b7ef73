#include "actors/sessions/seat.hpp"

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/thrown.hpp"

namespace parlour::actors {

seat_actor::behavior_type seat(seat_actor::stateful_pointer<seat_state> self,
                               SeatParts parts, SeatCalls calls) {
  return {
      [=](const say& what) {
        if (parts.time->left_behind)
          return;
        const auto reason = thrown_by([&] {
          if (calls.on_say)
            calls.on_say(what.session, *what.output);
        });
        if (reason)
          parts.observer->log("a seat did not show what was said: " + *reason);
        if (auto session = parts.sessions->find(what.session))
          self->send(session, output_done{what.output->id, !reason, what.work});
      },
      [=](const session_over& what) {
        if (!calls.on_over)
          return;
        if (auto reason = thrown_by([&] { calls.on_over(what.session); }))
          parts.observer->log("a seat did not take its session's end: " +
                              *reason);
      },
      [=](const next_session& what) {
        if (calls.on_next)
          calls.on_next(what.session);
      },
  };
}

} // namespace parlour::actors
