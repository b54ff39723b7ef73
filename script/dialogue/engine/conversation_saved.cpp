// The part of a conversation that turns it into bytes and back
// (saved/archive.hpp), and goes on with another port.
#include <utility>

#include "script/dialogue/agenda/saved_step.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/engine/conversation_implementation.hpp"
#include "script/dialogue/saved/reader.hpp"
#include "script/dialogue/saved/writer.hpp"

namespace parlour::dialogue {

// The interpreter's state comes first in the bytes but is written last, as the
// parts tell the writer which activations belong to it.
std::string Conversation::save() const {
  const auto& parts = *implementation_;
  Writer writer(*parts.context.program);
  writer.write(parts);
  return writer.finish(parts.interpreter);
}

Expected<std::unique_ptr<Conversation>>
Conversation::restore(std::shared_ptr<const script::Program> program,
                      Options options, Port& port, std::string_view bytes) {
  Reader reader(program, bytes);
  auto conversation = std::make_unique<Conversation>(std::move(program),
                                                     std::move(options), port);
  auto& parts = *conversation->implementation_;
  reader.begin(parts.interpreter);
  reader(parts);
  if (auto whole = reader.finish(); !whole)
    return tl::make_unexpected(std::move(whole.error()));
  return conversation;
}

void Conversation::resume(Timestamp now) {
  if (ended())
    return;
  implementation_->context.now = now;
  implementation_->resume();
}

// After a crash, whoever talks may not know any more what he was asked. Where
// something is still to come or to be said, that leads on by itself.
void Conversation::ask_again() {
  if (!ended() && !has_work() && !awaiting_frame() && !expects_outcome())
    implementation_->topics.ask_again();
}

bool Conversation::expects_outcome() const {
  const auto& parts = *implementation_;
  return waits_for_answer() || parts.sockets.any() || parts.output.plays();
}

bool Conversation::awaits_reply(Correlation correlation) const {
  return implementation_->requests.awaits(correlation);
}

// What is lost is handed out by the next steps: no script runs here, so that a
// frame may be awaited meanwhile. The port is told of what is private before it
// is shown anything.
void ConversationImplementation::resume() {
  inbox.number_anew();
  context.privacy.resume(context.now);
  frames.conceal();
  for (auto& lost : requests.lost())
    lose(std::move(lost));
  for (auto& lost : outside.resume())
    lose(std::move(lost));
  for (auto& lost : sockets.lose_all(inbox))
    lose(std::move(lost));
  timers.resume();
  topics.resume();
  output.resume();
}

// No deadline may ring for it before its step comes: the script would be told
// twice.
void ConversationImplementation::lose(WaitOutcome over) {
  waits.forget_request(over.wait);
  timers.cancel_wait(over.wait);
  lost_.push_back(std::move(over));
}

} // namespace parlour::dialogue
