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
                               SeatParts given, SeatCalls calls) {
  self->state.parts = std::move(given);
  self->state.calls = std::move(calls);
  return traced<seat_actor::behavior_type>(
      ActorTrace(*self->state.parts.observer, seat_state::name,
                 self->state.parts.name),
      [=](const say& what) {
        auto& state = self->state;
        if (state.parts.time->left_behind)
          return;
        state.session = what.session;
        const bool shown =
            call_out(state.parts, "a seat did not show what was said: ", [&] {
              if (state.calls.on_say)
                state.calls.on_say(what.session, *what.output);
            });
        if (auto speaker = state.parts.sessions->find(what.session))
          self->send(speaker, output_done{what.output->id, shown, what.work});
      },
      [=](const session_over& what) {
        auto& state = self->state;
        if (state.session == what.session)
          state.session.clear();
        call_out(state.parts, "a seat did not take its session's end: ", [&] {
          if (state.calls.on_over)
            state.calls.on_over(what.session);
        });
      },
      [=](const next_session& what) {
        auto& state = self->state;
        call_out(state.parts, "a seat did not take its next session: ", [&] {
          if (state.calls.on_next)
            state.calls.on_next(what.session);
        });
      },
      [=](const turns_done& what) {
        auto& state = self->state;
        call_out(state.parts,
                 "a seat did not take that its turns are done: ", [&] {
                   if (state.calls.on_turns_done)
                     state.calls.on_turns_done(what.session, what.turn);
                 });
      },
      [=](const leave_seat&) { self->quit(); },
      [=](const get_status& what) {
        auto& state = self->state;
        return tell_status(
            self, what,
            {state.parts.name, state.session.empty()
                                   ? "waits"
                                   : "shows session " + state.session});
      });
}

// By the names that there are few of: a node may have seats of many visitors.
std::string configured_name(const seat_actor& seat,
                            const TextMap<seat_actor>& seats,
                            const std::vector<SeatSettings>& configured) {
  for (const auto& one : configured)
    if (const auto found = seats.find(one.name);
        found != seats.end() && found->second == seat)
      return one.name;
  return {};
}

} // namespace parlour::actors
