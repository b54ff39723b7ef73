#include "actors/sessions/seat.hpp"

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/exception_text.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

namespace {

// Foreign code is called here: what it throws must not end the seat, and once
// the node is left behind nobody is called at all. False if it threw.
template <class Call>
bool call_out(const SeatParts& parts, const char* what, Call call) {
  if (parts.time->left_behind)
    return true;
  const auto reason = catch_to_string(call);
  if (reason)
    parts.observer->log(what + *reason);
  return !reason;
}

} // namespace

// The tool's callbacks run on the seat's own actor: a slow one delays this seat
// alone.
seat_actor::behavior_type seat(seat_actor::stateful_pointer<seat_state> self,
                               SeatParts parts, SeatCalls calls) {
  return traced<seat_actor::behavior_type>(
      ActorTrace(*parts.observer, seat_state::name, parts.name),
      [=](const say& what) {
        if (parts.time->left_behind)
          return;
        self->state.session = what.session;
        const bool shown =
            call_out(parts, "a seat did not show what was said: ", [&] {
              if (calls.on_say)
                calls.on_say(what.session, *what.output);
            });
        if (auto session = parts.sessions->find(what.session))
          self->send(session, output_done{what.output->id, shown, what.work});
      },
      [=](const session_over& what) {
        if (self->state.session == what.session)
          self->state.session.clear();
        call_out(parts, "a seat did not take its session's end: ", [&] {
          if (calls.on_over)
            calls.on_over(what.session);
        });
      },
      [=](const next_session& what) {
        call_out(parts, "a seat did not take its next session: ", [&] {
          if (calls.on_next)
            calls.on_next(what.session);
        });
      },
      [=](const turns_done& what) {
        call_out(parts, "a seat did not take that its turns are done: ", [&] {
          if (calls.on_turns_done)
            calls.on_turns_done(what.session, what.turn);
        });
      },
      [=](const leave_seat&) { self->quit(); },
      [=](const get_status& what) {
        const auto& session = self->state.session;
        return tell_status(self, what,
                           {parts.name, session.empty()
                                            ? "waits"
                                            : "shows session " + session});
      });
}

} // namespace parlour::actors
