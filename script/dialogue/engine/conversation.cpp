#include "script/dialogue/engine/conversation.hpp"

#include <utility>

#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

Conversation::Conversation(std::shared_ptr<const script::Program> program,
                           Options options, Port& port)
    : implementation_(std::make_unique<ConversationImplementation>(
          std::move(program), std::move(options), port)) {}

Conversation::~Conversation() = default;

// The runner gets `effects` before that is made. It only keeps the reference:
// no script runs before the first input.
ConversationImplementation::ConversationImplementation(
    std::shared_ptr<const script::Program> program, ConversationOptions options,
    Port& port)
    : interpreter(program),
      context(interpreter, std::move(program), std::move(options), port),
      timers(port), inbox(context.turns), messenger(context, inbox),
      frames(context, interpreter), reactions(context), view(context, frames),
      texts(context, interpreter, messenger, view), running(context, messenger),
      runner(context, interpreter, messenger, timers, running, effects),
      question(context, frames),
      output(context, reactions, messenger, timers, question),
      questions(context, frames, running, texts, reactions, question, output),
      topics(context, messenger, frames, running, texts, runner, question,
             output, questions),
      sockets(context),
      requests(context, messenger, timers, running, questions.whereabouts),
      outside(context, timers, running, sockets),
      waits(context, runner, requests, outside, topics),
      machine(context, timers, runner, waits, topics),
      heard_grammar(context, messenger, questions.whereabouts),
      answers(context, messenger, inbox, topics),
      message_end(context, output, sockets),
      pipeline(context, messenger, inbox, runner, running, reactions, topics,
               waits, machine, answers, message_end, handled),
      topic_effects(context, frames, running, output, questions.words,
                    questions.confirmations, questions.repairs),
      reaction_effects(context, messenger, reactions, running, questions.offers,
                       handled),
      time_effects(context, timers, running),
      effects(view, running, topic_effects, reaction_effects, requests,
              time_effects, outside) {}

void Conversation::open(Timestamp now) {
  implementation_->context.now = now;
  implementation_->open();
}

void Conversation::receive(Message message) {
  receive(std::make_shared<const Message>(std::move(message)));
}

void Conversation::receive(std::shared_ptr<const Message> message) {
  if (!ended())
    implementation_->receive(std::move(message));
}

void Conversation::take_acts(std::span<const ActPointer> acts, Timestamp now) {
  if (ended())
    return;
  implementation_->context.now = now;
  implementation_->take_acts(acts);
}

bool Conversation::has_work() const {
  return implementation_->has_work();
}

bool Conversation::awaiting_frame() const {
  return implementation_->topics.awaiting_frame();
}

// The time is set even where there is nothing to do: whoever looks at the
// conversation then sees it as of now.
bool Conversation::step(Timestamp now) {
  implementation_->context.now = now;
  if (has_work())
    implementation_->take_input();
  return has_work();
}

void Conversation::frame_applied(FrameResult result, Timestamp now) {
  if (ended() || !awaiting_frame())
    return;
  implementation_->context.now = now;
  implementation_->topics.frame_applied(std::move(result));
  implementation_->go_on();
}

// The query may be a topic's own (<query>), which the topic engine knows, or a
// script's <querydb>. Ids of both come from one counter.
void Conversation::query_answered(QueryId id, Expected<Value> outcome,
                                  Timestamp now) {
  if (ended())
    return;
  auto& parts = *implementation_;
  parts.context.now = now;
  parts.begin_event();
  if (parts.topics.query_answered(id, outcome))
    parts.go_on();
  else
    parts.answered(id, std::move(outcome));
}

void Conversation::file_answered(QueryId id, Expected<Value> outcome,
                                 Timestamp now) {
  if (ended())
    return;
  implementation_->context.now = now;
  implementation_->begin_event();
  implementation_->answered(id, std::move(outcome));
}

void Conversation::component_answered(QueryId id, Expected<void> outcome,
                                      Timestamp now) {
  file_answered(id, std::move(outcome).map([] { return Value(); }), now);
}

void Conversation::socket_opened(SocketId id, Expected<void> outcome,
                                 Timestamp now) {
  if (ended())
    return;
  implementation_->context.now = now;
  implementation_->begin_event();
  if (auto over = implementation_->sockets.opened(id, std::move(outcome)))
    implementation_->end_wait(std::move(*over));
  implementation_->go_on();
}

void Conversation::socket_closed(SocketId id) {
  implementation_->sockets.closed(id);
}

void Conversation::timer_fired(TimerId id, Timestamp now) {
  if (ended())
    return;
  implementation_->context.now = now;
  implementation_->timer_fired(id);
}

// A seat says that it has shown the words when they may still be spoken, so a
// loudspeaker is the one that counts.
void Conversation::output_finished(OutputId id, bool played, Timestamp now) {
  if (ended())
    return;
  implementation_->context.now = now;
  if (!played)
    implementation_->output.interrupted(id, {});
  else if (!implementation_->output.is_voiced())
    implementation_->output.finished(id);
  implementation_->go_on();
}

void Conversation::close(Timestamp now) {
  implementation_->context.now = now;
  implementation_->close();
}

bool Conversation::ended() const {
  return implementation_->context.ending.is_over();
}

bool Conversation::waits_for_answer() const {
  const auto& parts = *implementation_;
  return parts.topics.awaiting_frame() || parts.topics.waits_for_answer() ||
         parts.requests.waits_for_answer() ||
         parts.outside.waits_for_answer() || parts.output.waits_for_words();
}

// Turns that somebody may have begun without words do not count: nothing has
// been said yet that could be answered.
bool Conversation::has_answered(Timestamp now) const {
  const auto& parts = *implementation_;
  return !parts.has_work() && !waits_for_answer() && !parts.output.plays() &&
         !parts.context.turns.any_said(now);
}

// To look at a topic that the session has not touched would give it its frame.
Value Conversation::slot_value(std::string_view topic,
                               std::string_view slot) const {
  const auto& parts = *implementation_;
  const auto id = parts.context.program->topic(topic);
  return id == script::no_id || !parts.frames.has(id)
             ? Value()
             : parts.view.slot(id, parts.context.topic(id).slot(slot));
}

std::vector<Message> Conversation::take_unread() {
  return implementation_->take_unread();
}

std::string Conversation::state() const {
  const auto* active = implementation_->context.active_state();
  return active ? active->name : std::string();
}

std::string Conversation::current_topic() const {
  const auto& parts = *implementation_;
  const auto topic = parts.frames.order().current();
  return topic ? parts.context.topic(*topic).name : std::string();
}

} // namespace parlour::dialogue
