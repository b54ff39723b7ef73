#include "script/dialogue/engine/conversation.hpp"

#include <utility>

#include "script/dialogue/engine/conversation_implementation.hpp"

namespace parlour::dialogue {

Conversation::Conversation(std::shared_ptr<const script::Program> program,
                           Options options, Port& port)
    : implementation_(std::make_unique<Implementation>(
          std::move(program), std::move(options), port)) {}

Conversation::~Conversation() = default;

void Conversation::open(Timestamp now) {
  implementation_->core.now = now;
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
  implementation_->core.now = now;
  implementation_->take_acts(acts);
}

bool Conversation::has_work() const {
  return implementation_->has_work();
}

bool Conversation::awaiting_frame() const {
  return implementation_->core.topics.awaiting_frame();
}

bool Conversation::step(Timestamp now) {
  implementation_->core.now = now;
  if (has_work())
    implementation_->take_input();
  return has_work();
}

void Conversation::frame_applied(FrameResult result, Timestamp now) {
  if (ended() || !awaiting_frame())
    return;
  implementation_->core.now = now;
  implementation_->core.topics.frame_applied(std::move(result));
  implementation_->go_on();
}

void Conversation::query_answered(QueryId id, Expected<ResultSet> outcome,
                                  Timestamp now) {
  if (ended())
    return;
  auto& core = implementation_->core;
  core.now = now;
  implementation_->begin_event();
  if (core.topics.query_answered(id, outcome) ||
      core.effects.answered(id, std::move(outcome).map([](ResultSet rows) {
        return Value(std::move(rows));
      })))
    implementation_->go_on();
}

void Conversation::file_answered(QueryId id, Expected<Value> outcome,
                                 Timestamp now) {
  if (ended())
    return;
  implementation_->core.now = now;
  implementation_->begin_event();
  if (implementation_->core.effects.answered(id, std::move(outcome)))
    implementation_->go_on();
}

void Conversation::component_answered(QueryId id, Expected<void> outcome,
                                      Timestamp now) {
  file_answered(id, std::move(outcome).map([] { return Value(); }), now);
}

void Conversation::socket_opened(SocketId id, Expected<void> outcome,
                                 Timestamp now) {
  if (ended())
    return;
  implementation_->core.now = now;
  implementation_->begin_event();
  implementation_->core.effects.sockets.opened(id, std::move(outcome));
  implementation_->go_on();
}

void Conversation::socket_closed(SocketId id) {
  implementation_->core.effects.sockets.closed(id);
}

void Conversation::timer_fired(TimerId id, Timestamp now) {
  if (ended())
    return;
  implementation_->core.now = now;
  implementation_->timer_fired(id);
}

void Conversation::output_finished(OutputId id, bool played, Timestamp now) {
  if (ended())
    return;
  implementation_->core.now = now;
  if (played)
    implementation_->core.mouth.finished(id);
  else
    implementation_->core.mouth.interrupted(id, {});
  implementation_->go_on();
}

void Conversation::close(Timestamp now) {
  implementation_->core.now = now;
  implementation_->close();
}

bool Conversation::ended() const {
  return implementation_->core.ended;
}

bool Conversation::waits_for_answer() const {
  const auto& core = implementation_->core;
  return core.topics.awaiting_frame() || core.topics.waits_for_answer() ||
         core.effects.waits_for_answer() || core.mouth.waits_for_words();
}

Value Conversation::slot_value(std::string_view topic,
                               std::string_view slot) const {
  const auto& core = implementation_->core;
  auto id = core.program->topic(topic);
  return id == script::no_id ? Value()
                             : core.effects.slot(id, core.topic(id).slot(slot));
}

std::vector<Message> Conversation::take_unread() {
  return implementation_->take_unread();
}

std::string Conversation::state() const {
  const auto& core = implementation_->core;
  return core.states.active() == script::no_id
             ? std::string()
             : core.program->states[core.states.active()].name;
}

std::string Conversation::current_topic() const {
  const auto& core = implementation_->core;
  auto topic = core.order.current();
  return topic ? core.topic(*topic).name : std::string();
}

} // namespace parlour::dialogue
