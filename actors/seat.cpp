#include "actors/seat.hpp"

namespace parlour::actors {

seat_actor::behavior_type seat(seat_actor::stateful_pointer<seat_state> self,
                               Services* services, SeatCalls calls) {
  return {
      [=](const say& what) {
        calls.on_say(what.session, *what.output);
        if (auto session = services->sessions.find(what.session))
          self->send(session, output_done{what.output->id, true, what.work});
      },
      [=](const session_over& what) { calls.on_over(what.session); },
  };
}

} // namespace parlour::actors
