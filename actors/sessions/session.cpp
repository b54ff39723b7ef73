#include "actors/sessions/session.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <fmt/format.h>

#include "actors/support/actor_trace.hpp"
#include "actors/support/exception_text.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

namespace {

namespace input = dialogue::input;
using Self = session_actor::stateful_pointer<session_state>;

Timestamp now(Self self) {
  return self->state.time->now();
}

const dialogue::Conversation& conversation_of(Self self) {
  return self->state.dialogue->conversation();
}

// Nothing else changes the conversation: what comes by a message, a timer or an
// answer is an input with its time (engine rule 7.2).
void take(Self self, dialogue::SessionInput input) {
  assert(!conversation_of(self).awaiting_frame() ||
         std::holds_alternative<input::FrameApplied>(input) ||
         std::holds_alternative<input::Resumed>(input));
  self->state.dialogue->take(std::move(input), now(self));
}

SessionPort& port_of(Self self) {
  return self->state.dialogue->port();
}

ActorTrace trace_of(Self self) {
  const auto& id = port_of(self).id();
  return {self->state.parts->observer, session_state::name, id, id};
}

status_told tell_session_status(Self self, const get_status& what) {
  const auto& port = port_of(self);
  return tell_status(self, what,
                     {port.id(), self->state.dialogue->doing(),
                      port.last_error(), port.children()});
}

slot_told tell_slot(Self self, const get_slot& what) {
  return {conversation_of(self).slot_value(what.topic, what.slot)};
}

state_told tell_state(Self self) {
  return {conversation_of(self).state()};
}

// Between its end and the moment when nobody can find it any more: what still
// comes may be the seat's next session's.
session_actor::behavior_type over(Self self) {
  return traced<session_actor::behavior_type>(
      trace_of(self), [](const begin_session&) {},
      [=](const deliver& what) {
        self->state.dialogue->pass_on(what.messages);
      },
      [](const take_step&) {}, [](const timer_due&) {}, [](const wake_up&) {},
      [](const query_outcome&) {}, [](const file_outcome&) {},
      [](const socket_told&) {}, [](const output_done&) {},
      [=](const get_slot& what) { return tell_slot(self, what); },
      [=](const get_state&) { return tell_state(self); },
      [](const end_session&) {},
      [=](const record_written& what) {
        self->state.dialogue->written(what.record);
      },
      [](const change_program&) { return program_changed{.has_ended = true}; },
      [](const scripts_over&) {}, [](const rest_if_idle&) {},
      [=](const leave&) { self->quit(); },
      [=](const get_status& what) { return tell_session_status(self, what); });
}

// Only a change is told: the tracker counts sessions that wait, and in real
// time a node with one is not quiet (RealTime::quiet).
void tell_waiting(session_state& state, bool waits) {
  if (std::exchange(state.waits, waits) != waits)
    state.time->work.session_waits(waits);
}

// False where that ends the session, as it does a strict one that cannot write
// its journal: a crash could undo what it said next (engine rule 7.11).
bool finish_input(Self self) {
  auto& state = self->state;
  Expected<void> outcome;
  if (state.dialogue->is_stuck())
    outcome = fail(ErrorKind::file, "its journal cannot be written, and what "
                                    "it says may not leave without");
  else if (const auto& finish = state.parts->after_input)
    outcome = finish(*state.dialogue, now(self));
  if (!outcome)
    self->quit(
        caf::make_error(caf::sec::runtime_error, to_string(outcome.error())));
  return outcome.has_value();
}

// Turns are counted, and who numbers them at the seat hears which are answered.
void tell_turns_done(Self self) {
  auto& state = self->state;
  const auto answered = state.meter.take_answered();
  const auto number = state.meter.take_done();
  if (number != 0 || answered.turns > 0)
    state.dialogue->turns_done(answered, number);
}

// -- another program ----------------------------------------------------------

// What scripts still do may take that long when their program is changed. A
// shorter time would cut off answers that are on their way; a longer one would
// let a kiosk say for longer what was just corrected.
constexpr Milliseconds time_for_scripts{30'000};

std::vector<std::string> go_over(Self self) {
  auto& state = self->state;
  state.scripts_due = {};
  state.parts = state.dialogue->change()->parts();
  return state.dialogue->go_over(now(self));
}

// Nobody waits to be told of what is lost any more.
void go_over_late(Self self) {
  if (const auto lost = go_over(self); !lost.empty())
    self->state.parts->observer.log(
        fmt::format("session {} goes on with the changed scripts without {}",
                    port_of(self).id(), fmt::join(lost, ", ")));
}

// After each input: steps are taken one at a time through the mailbox, so that
// whatever has arrived is queued before the next (engine rule 3).
void go_on(Self self) {
  auto& state = self->state;
  if (!finish_input(self))
    return;
  const auto& conversation = conversation_of(self);
  if (conversation.ended()) {
    tell_waiting(state, false);
    tell_turns_done(self);
    state.dialogue->close(state.asked_to_end ? std::vector<Message>()
                                             : state.dialogue->take_unread());
    self->become(over(self));
    return;
  }
  tell_waiting(state, conversation.waits_for_answer());
  const bool rests = state.stepping || conversation.awaiting_frame() ||
                     !conversation.has_work();
  if (rests) {
    if (!state.stepping && conversation.has_answered(now(self)))
      tell_turns_done(self);
    if (!state.dialogue->may_go_over(now(self)))
      return;
    go_over_late(self);
    return go_on(self);
  }
  state.stepping = true;
  self->send(self, take_step{state.time->work.begin()});
}

// At once where it is at rest; else what it does comes to its end first. The
// one that came last counts.
program_changed change_programs(Self self, const change_program& what) {
  auto& state = self->state;
  state.dialogue->change_to(what.change);
  if (!state.dialogue->may_go_over(now(self))) {
    auto& due_times = state.time->due_times;
    state.scripts_due = {due_times,
                         due_times.add(now(self) + time_for_scripts.count(),
                                       DueTimes::Of::session)};
    self->delayed_send(self, time_for_scripts, scripts_over{what.change});
    return {.later = true};
  }
  auto lost = go_over(self);
  go_on(self);
  return {.lost = std::move(lost)};
}

// What still waits in scripts ends with an error; what their <catch> begins
// then, or what is being said, ends in its own time.
void end_scripts(Self self, const scripts_over& what) {
  auto& state = self->state;
  if (state.dialogue->change() != what.change)
    return;
  const auto work = state.time->work.begin();
  state.scripts_due = {};
  state.dialogue->end_scripts(now(self));
  go_on(self);
}

// Session.Started is handled, up to the opening prompt; or it goes on after a
// crash. What it had posted before, and may not have reached anybody, leaves
// after it has resumed.
void begin(Self self) {
  const auto saved = std::exchange(self->state.saved, nullptr);
  if (saved) {
    take(self, input::Resumed{.after_crash = true});
    port_of(self).post_again(saved->posts);
  } else {
    take(self, input::Begun());
  }
  go_on(self);
}

// Where components have an instance for each session, what this one says to
// them from its first word on is to find its own. The answer is awaited: no
// other message is taken before the session has begun.
void settle_and_begin(Self self, const InFlight& work) {
  const auto& parts = *self->state.parts;
  if (!parts.bus.table()->has_instances_by_session())
    return begin(self);
  self->request(parts.supervisor, caf::infinite,
                session_begins{port_of(self).id(), work})
      .await([self, held = work](const session_settled&) { begin(self); },
             [=](const caf::error&) { begin(self); }); // the node stops
}

// A frame may be awaited by now, if something else was taken in between: then
// its answer goes on.
void take_one_step(Self self) {
  auto& state = self->state;
  assert(state.stepping && "only a session asks itself for a step");
  state.stepping = false;
  if (!conversation_of(self).awaiting_frame())
    take(self, input::Stepped());
  go_on(self);
}

// Messages are queued and not handled here: the conversation decides at its
// next step which one is its turn (engine rule 3).
void queue(Self self, deliver& what) {
  auto& state = self->state;
  if (state.meter.take(what.messages, state.parts->bus, what.arrived))
    port_of(self).turn_begins(state.meter.number());
  for (auto& message : what.messages)
    take(self, dialogue::received(std::move(message)));
  go_on(self);
}

// The conversation does not know the number of one that was just cancelled.
void hear_timer(Self self, const timer_due& what) {
  port_of(self).timer_is_over(what.id);
  take(self, input::TimerFired{what.id});
  go_on(self);
}

void hear_query(Self self, const query_outcome& what) {
  port_of(self).query_is_over(what.id);
  take(self, input::QueryAnswered{what.id, what.outcome});
  go_on(self);
}

void hear_file(Self self, const file_outcome& what) {
  take(self, input::FileAnswered{what.id, what.outcome});
  go_on(self);
}

// The supervisor's answer holds no work, and may come when all is over.
void hear_component(Self self, dialogue::QueryId id, Expected<void> outcome) {
  const auto work = self->state.time->work.begin();
  if (conversation_of(self).ended())
    return;
  take(self, input::ComponentAnswered{id, std::move(outcome)});
  go_on(self);
}

// Its messages go by the routes, then are queued. That it is closed is told
// twice: by an event for the scripts, and for the conversation to forget it.
void hear_socket(Self self, const socket_told& what) {
  using enum SocketEvent::Kind;
  if (what.event.kind == opened)
    take(self, input::SocketOpened{what.id, {}});
  else if (what.event.kind == failed)
    take(self, input::SocketOpened{what.id,
                                   fail(ErrorKind::network, what.event.text)});
  else
    for (auto& message : port_of(self).hear_socket(what.id, what.event))
      take(self, dialogue::received(std::move(message)));
  if (what.event.kind == closed || what.event.kind == failed)
    port_of(self).socket_is_over(what.id);
  if (what.event.kind == closed)
    take(self, input::SocketClosed{what.id});
  go_on(self);
}

void hear_seat(Self self, const output_done& what) {
  take(self, input::OutputFinished{what.id, what.played});
  go_on(self);
}

// Awaited: all other messages stay in the mailbox meanwhile (engine rule 5.12).
void ask_frame(Self self, const topic_frame_actor& frame,
               std::shared_ptr<const dialogue::FrameRequest> request) {
  // No deadline: the frame computes within the limits of its script, and its
  // end is an error here.
  self->request(
          frame, caf::infinite,
          apply_changes{std::move(request), self->state.time->work.begin()})
      .await(
          [=](const frame_changed& what) {
            take(self, input::FrameApplied{*what.result});
            go_on(self);
          },
          [=](const caf::error& error) {
            self->quit(caf::make_error(caf::sec::runtime_error,
                                       "a topic's frame was lost: " +
                                           self->system().render(error)));
          });
}

// The port calls back into this actor only during its own messages, so the
// lambdas may hold the bare pointer; the journal's thread holds a handle.
void set_up(Self self, std::shared_ptr<const SessionParts> parts,
            SessionOrder order) {
  auto& state = self->state;
  state.parts = std::move(parts);
  state.time = &state.parts->time;
  auto port = std::make_unique<SessionPort>(
      self, state.parts, order.id, std::move(order.seat),
      [self](const auto& frame, auto request) {
        ask_frame(self, frame, std::move(request));
      },
      [self](auto query, auto outcome) {
        hear_component(self, query, std::move(outcome));
      });
  auto when_written = [self](std::uint64_t record) -> std::function<void()> {
    return [record, time = self->state.time, session = session_actor(self)] {
      time->main_thread.post([=, work = time->work.begin()] {
        caf::anon_send(session, record_written{record, work});
      });
    };
  };
  state.saved = std::move(order.saved);
  if (state.saved)
    state.meter.go_on(state.saved->turns.taken);
  state.dialogue = std::make_unique<SessionDialogue>(
      state.parts->program,
      dialogue::ConversationOptions{std::move(order.id), order.seed,
                                    state.parts->phrases, order.seat_name},
      std::move(port),
      JournalUse{state.parts->journal, state.parts->strict_journal,
                 std::move(when_written)},
      state.saved.get());
}

} // namespace

session_state::~session_state() {
  if (time)
    tell_waiting(*this, false);
}

session_actor::behavior_type
session(session_actor::stateful_pointer<session_state> self,
        std::shared_ptr<const SessionParts> parts, SessionOrder order) {
  end_by_what_is_thrown(self);
  set_up(self, std::move(parts), std::move(order));
  return traced<session_actor::behavior_type>(
      trace_of(self),
      [=](const begin_session& what) { settle_and_begin(self, what.work); },
      [=](deliver& what) { queue(self, what); },
      [=](const take_step&) { take_one_step(self); },
      [=](const timer_due& what) { hear_timer(self, what); },
      [=](const wake_up&) { port_of(self).wake(); },
      [=](const query_outcome& what) { hear_query(self, what); },
      [=](const file_outcome& what) { hear_file(self, what); },
      [=](const socket_told& what) { hear_socket(self, what); },
      [=](const output_done& what) { hear_seat(self, what); },
      [=](const get_slot& what) { return tell_slot(self, what); },
      [=](const get_state&) { return tell_state(self); },
      [=](const end_session&) {
        self->state.asked_to_end = true;
        take(self, input::Closed());
        go_on(self);
      },
      [=](const record_written& what) {
        self->state.dialogue->written(what.record);
      },
      [=](const change_program& what) { return change_programs(self, what); },
      [=](const scripts_over& what) { end_scripts(self, what); },
      [=](const rest_if_idle& what) {
        self->state.dialogue->rest_if_idle(what.idle, now(self));
      },
      [](const leave&) {},
      [=](const get_status& what) { return tell_session_status(self, what); });
}

} // namespace parlour::actors
