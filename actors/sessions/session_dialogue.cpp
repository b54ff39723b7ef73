#include "actors/sessions/session_dialogue.hpp"

#include <utility>

namespace parlour::actors {

SessionDialogue::SessionDialogue(std::shared_ptr<const script::Program> program,
                                 dialogue::ConversationOptions options,
                                 MakePort make_port)
    : program_(std::move(program)), options_(std::move(options)),
      make_port_(std::move(make_port)), port_(make_port_()),
      conversation_(std::make_unique<dialogue::Conversation>(program_, options_,
                                                             *port_)) {}

Expected<void> SessionDialogue::renew(Timestamp now) {
  const bool keeps_port = conversation_->expects_outcome();
  auto port = keeps_port ? nullptr : make_port_();
  auto next = go_on(keeps_port ? *port_ : *port, conversation_->save());
  if (!next)
    return tl::make_unexpected(std::move(next.error()));
  conversation_ = std::move(*next);
  if (keeps_port)
    return {};
  port_ = std::move(port); // what worked for the one before ends with its port
  conversation_->resume(now);
  return {};
}

Expected<std::unique_ptr<dialogue::Conversation>>
SessionDialogue::go_on(SessionPort& port, const std::string& bytes) const {
  return dialogue::Conversation::restore(program_, options_, port, bytes);
}

} // namespace parlour::actors
