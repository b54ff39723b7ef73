#include "actors/sessions/session.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/exception_text.hpp"
#include "actors/support/tell_status.hpp"
#include "runtime/message/typed_turn.hpp"

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
  self->state.dialogue->take(std::move(input), now(self));
}

SessionPort& port_of(Self self) {
  return self->state.dialogue->port();
}

ActorTrace trace_of(Self self) {
  const auto& id = port_of(self).id();
  return {self->state.parts->observer, session_state::name, id, id};
}

// "waits for an answer in state Welcome".
std::string doing_of(const session_state& state) {
  const auto& conversation = state.dialogue->conversation();
  if (conversation.ended())
    return "has ended";
  const std::string at =
      conversation.state().empty() ? "" : " in state " + conversation.state();
  if (conversation.awaiting_frame())
    return "waits for a topic's frame" + at;
  if (conversation.has_work())
    return "takes what has come" + at;
  return (conversation.waits_for_answer() ? "waits for an answer" : "waits") +
         at;
}

status_told tell_session_status(Self self, const get_status& what) {
  const auto& port = port_of(self);
  return tell_status(
      self, what,
      {port.id(), doing_of(self->state), port.last_error(), port.children()});
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
        self->send(self->state.parts->manager,
                   forward{what.messages, what.work});
      },
      [](const take_step&) {}, [](const timer_due&) {},
      [](const query_outcome&) {}, [](const file_outcome&) {},
      [](const socket_told&) {}, [](const output_done&) {},
      [=](const get_slot& what) { return tell_slot(self, what); },
      [=](const get_state&) { return tell_state(self); },
      [](const end_session&) {},
      [=](const record_written& what) {
        self->state.dialogue->written(what.record);
      },
      [=](const leave&) { self->quit(); },
      [=](const get_status& what) { return tell_session_status(self, what); });
}

// Only a change is told: the tracker counts sessions that wait.
// A node with a session that waits is not quiet in real time: the answer is
// still to come (RealTime::quiet).
void tell_waiting(session_state& state, bool waits) {
  if (std::exchange(state.waits, waits) != waits)
    state.time->work.session_waits(waits);
}

// False where that ends the session.
// A strict session that cannot write its journal ends here: whatever it said
// next could not be taken back by a crash (engine rule 7.11).
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
  const bool are_numbered = state.turns_done != state.turns_taken;
  state.turns_done = state.turns_taken;
  if (are_numbered || answered.turns > 0)
    state.dialogue->turns_done(answered, are_numbered ? state.turns_done : 0);
}

// After each input: steps are taken one at a time through the mailbox, so that
// whatever has arrived is queued before the next (engine rule 3).
//
//   a message comes    it is queued; take_step is sent, behind what has come
//   take_step          one step; again take_step, until nothing is left to do
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
  if (state.stepping || conversation.awaiting_frame() ||
      !conversation.has_work()) {
    if (!state.stepping && conversation.has_answered(now(self)))
      tell_turns_done(self);
    return;
  }
  state.stepping = true;
  self->send(self, take_step{state.time->work.begin()});
}

// Session.Started is handled, up to the opening prompt; or it goes on after a
// crash.
// What the session had posted before the crash, and may not have reached
// anybody, leaves after it has resumed.
void begin(Self self) {
  const auto saved = std::exchange(self->state.saved, nullptr);
  if (!saved)
    take(self, input::Begun());
  else
    take(self, input::Resumed{.after_crash = true});
  if (saved)
    port_of(self).post_again(saved->posts);
  go_on(self);
}

// Where components have an instance for each session, what this one says to
// them from its first word on is to find its own.
// The answer is awaited, so that no other message is taken before the session
// has begun.
void settle_and_begin(Self self, const SessionId& id, const InFlight& work) {
  const auto& parts = *self->state.parts;
  if (!parts.bus.table()->has_instances_by_session())
    return begin(self);
  self->request(parts.supervisor, caf::infinite, session_begins{id, work})
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

// Lines without a number are turns of their own only where no line of the row
// has one (TurnMeter::take).
void note_turns(Self self, const deliver& what) {
  auto& state = self->state;
  std::uint64_t lines = 0;
  std::uint64_t numbered = 0;
  for (const auto& message : what.messages) {
    const auto number = number_of_turn(message);
    state.turns_taken = std::max(state.turns_taken, number);
    if (number != 0)
      ++numbered;
    else if (message.command == "RecognitionResult" &&
             state.parts->bus.table()->begins_turn(message))
      ++lines;
  }
  if (lines == 0 && numbered == 0)
    return;
  state.meter.take(lines, numbered, state.turns_taken,
                   what.arrived != 0 ? what.arrived : NodeMetrics::now());
  port_of(self).turn_begins(state.meter.number());
}

// Messages are queued and not handled here: the conversation decides at its
// next step which one is its turn (engine rule 3).
void queue(Self self, const deliver& what) {
  note_turns(self, what);
  for (const auto& message : what.messages)
    take(self, dialogue::received(message));
  go_on(self);
}

// The frame's answer is awaited: CAF keeps all other messages back until then.
void expect_input(Self self) {
  assert(!conversation_of(self).awaiting_frame());
  (void)self;
}

// A timer that was cancelled a moment ago may still arrive: the conversation
// does not know its number any more.
void hear_timer(Self self, const timer_due& what) {
  expect_input(self);
  port_of(self).timer_is_over(what.id);
  take(self, input::TimerFired{what.id});
  go_on(self);
}

// The outcome is a result set, or an error that the script may catch.
void hear_query(Self self, const query_outcome& what) {
  expect_input(self);
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

// Its messages go the way of all others: by the routes, then queued.
//
// That it is closed is told twice: the event `Closed` is for the scripts, the
// input SocketClosed lets the conversation forget it.
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
  expect_input(self);
  take(self, input::OutputFinished{what.id, what.played});
  go_on(self);
}

// Awaited: CAF keeps all other messages in the mailbox until the frame's answer
// is here (engine rule 5.12).
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
  auto make_port = [self, id = order.id, seat = std::move(order.seat)] {
    return std::make_unique<SessionPort>(
        self, self->state.parts, id, seat,
        [self](const auto& frame, auto request) {
          ask_frame(self, frame, std::move(request));
        },
        [self](auto query, auto outcome) {
          hear_component(self, query, std::move(outcome));
        });
  };
  auto when_written = [self](std::uint64_t record) -> std::function<void()> {
    return [record, time = self->state.time, session = session_actor(self)] {
      time->main_thread.post([=, work = time->work.begin()] {
        caf::anon_send(session, record_written{record, work});
      });
    };
  };
  state.saved = std::move(order.saved);
  if (state.saved)
    state.meter.go_on(state.turns_taken = state.saved->turns.taken);
  state.dialogue = std::make_unique<SessionDialogue>(
      state.parts->program,
      dialogue::ConversationOptions{std::move(order.id), order.seed,
                                    state.parts->phrases},
      std::move(make_port),
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
  const auto id = order.id;
  set_up(self, std::move(parts), std::move(order));
  return traced<session_actor::behavior_type>(
      trace_of(self),
      [=](const begin_session& what) { settle_and_begin(self, id, what.work); },
      [=](const deliver& what) { queue(self, what); },
      [=](const take_step&) { take_one_step(self); },
      [=](const timer_due& what) { hear_timer(self, what); },
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
      [](const leave&) {},
      [=](const get_status& what) { return tell_session_status(self, what); });
}

} // namespace parlour::actors
