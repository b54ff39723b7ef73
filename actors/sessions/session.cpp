#include "actors/sessions/session.hpp"

#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/thrown.hpp"

namespace parlour::actors {

namespace {

using Self = session_actor::stateful_pointer<session_state>;

Timestamp now(Self self) {
  return self->state.time->now();
}

// Between its end and the moment when nobody can find it any more: what still
// comes may be the seat's next session's.
session_actor::behavior_type over(Self self) {
  return {
      [](const begin_session&) {},
      [=](const deliver& what) {
        self->send(self->state.parts->manager,
                   forward{what.messages, what.work});
      },
      [](const take_step&) {},
      [](const timer_due&) {},
      [](const query_outcome&) {},
      [](const file_outcome&) {},
      [](const component_outcome&) {},
      [](const socket_told&) {},
      [](const output_done&) {},
      [=](const look& what) { what.at(*self->state.conversation); },
      [](const end_session&) {},
      [=](const leave&) { self->quit(); },
  };
}

void tell_waiting(session_state& state, bool waits) {
  if (std::exchange(state.waits, waits) != waits)
    state.time->work.session_waits(waits);
}

// After each input: steps are taken one at a time through the mailbox, so that
// whatever has arrived is queued before the next (engine rule 3).
void go_on(Self self) {
  auto& state = self->state;
  auto& conversation = *state.conversation;
  if (conversation.ended()) {
    tell_waiting(state, false);
    state.port->close(state.asked_to_end ? std::vector<Message>()
                                         : conversation.take_unread());
    self->become(over(self));
    return;
  }
  tell_waiting(state, conversation.waits_for_answer());
  if (state.stepping || conversation.awaiting_frame() ||
      !conversation.has_work())
    return;
  state.stepping = true;
  self->send(self, take_step{state.time->work.begin()});
}

void begin(Self self) {
  self->state.conversation->open(now(self));
  go_on(self);
}

// Where components have an instance for each session, what this one says to
// them from its first word on is to find its own.
void settle_and_begin(Self self, const SessionId& id, const Work& work) {
  const auto& parts = *self->state.parts;
  if (!parts.bus.table()->has_branches())
    return begin(self);
  self->request(parts.supervisor, caf::infinite, session_begins{id, work})
      .await([=](const session_settled&) { begin(self); },
             [=](const caf::error&) { begin(self); }); // the house stops
}

void take_one_step(Self self) {
  auto& state = self->state;
  state.stepping = false;
  if (!state.conversation->awaiting_frame())
    state.conversation->step(now(self));
  go_on(self);
}

void queue(Self self, const deliver& what) {
  for (const auto& message : what.messages)
    self->state.conversation->receive(message);
  go_on(self);
}

void hear_timer(Self self, const timer_due& what) {
  self->state.port->timer_is_over(what.id);
  self->state.conversation->timer_fired(what.id, now(self));
  go_on(self);
}

void hear_query(Self self, const query_outcome& what) {
  self->state.port->query_is_over(what.id);
  self->state.conversation->query_answered(what.id, what.outcome, now(self));
  go_on(self);
}

void hear_file(Self self, const file_outcome& what) {
  self->state.conversation->file_answered(what.id, what.outcome, now(self));
  go_on(self);
}

void hear_component(Self self, const component_outcome& what) {
  self->state.conversation->component_answered(what.id, what.outcome,
                                               now(self));
  go_on(self);
}

// Its messages go the way of all others: by the routes, then queued.
void hear_socket(Self self, const socket_told& what) {
  using enum SocketEvent::Kind;
  auto& state = self->state;
  auto& conversation = *state.conversation;
  if (what.event.kind == opened)
    conversation.socket_opened(what.id, {}, now(self));
  else if (what.event.kind == failed)
    conversation.socket_opened(
        what.id, fail(ErrorKind::network, what.event.text), now(self));
  else
    for (auto& message : state.port->hear_socket(what.id, what.event))
      conversation.receive(std::move(message));
  if (what.event.kind == closed || what.event.kind == failed)
    state.port->socket_is_over(what.id);
  if (what.event.kind == closed)
    conversation.socket_closed(what.id);
  go_on(self);
}

void hear_seat(Self self, const output_done& what) {
  self->state.conversation->output_finished(what.id, what.played, now(self));
  go_on(self);
}

void set_up(Self self, std::shared_ptr<const SessionParts> parts,
            SessionOrder order) {
  auto& state = self->state;
  state.parts = std::move(parts);
  state.time = &state.parts->time;
  state.port = std::make_unique<SessionPort>(self, state.parts, order.id,
                                             std::move(order.seat));
  dialogue::Conversation::Options options;
  options.session = std::move(order.id);
  options.seed = order.seed;
  options.phrases = state.parts->phrases;
  state.conversation = std::make_unique<dialogue::Conversation>(
      state.parts->program, std::move(options), *state.port);
}

} // namespace

session_state::~session_state() {
  if (time)
    tell_waiting(*this, false);
}

void ask_frame(Self self, const topic_frame_actor& frame,
               std::shared_ptr<const dialogue::FrameRequest> request) {
  // No deadline: the frame computes within the limits of its script, and its
  // end is an error here.
  self->request(
          frame, caf::infinite,
          apply_changes{std::move(request), self->state.time->work.begin()})
      .await(
          [=](const frame_changed& what) {
            self->state.conversation->frame_applied(*what.result, now(self));
            go_on(self);
          },
          [=](const caf::error& error) {
            self->quit(caf::make_error(caf::sec::runtime_error,
                                       "a topic's frame was lost: " +
                                           self->system().render(error)));
          });
}

session_actor::behavior_type
session(session_actor::stateful_pointer<session_state> self,
        std::shared_ptr<const SessionParts> parts, SessionOrder order) {
  end_by_what_is_thrown(self);
  const auto id = order.id;
  set_up(self, std::move(parts), std::move(order));
  return {
      [=](const begin_session& what) { settle_and_begin(self, id, what.work); },
      [=](const deliver& what) { queue(self, what); },
      [=](const take_step&) { take_one_step(self); },
      [=](const timer_due& what) { hear_timer(self, what); },
      [=](const query_outcome& what) { hear_query(self, what); },
      [=](const file_outcome& what) { hear_file(self, what); },
      [=](const component_outcome& what) { hear_component(self, what); },
      [=](const socket_told& what) { hear_socket(self, what); },
      [=](const output_done& what) { hear_seat(self, what); },
      [=](const look& what) { what.at(*self->state.conversation); },
      [=](const end_session&) {
        self->state.asked_to_end = true;
        self->state.conversation->close(now(self));
        go_on(self);
      },
      [](const leave&) {},
  };
}

} // namespace parlour::actors
