// SessionDialogue: the conversation of a session, and the port by which it
// reaches others. It can be renewed: the conversation is written, and another
// one goes on from the bytes with a port of its own, as it would in another
// process. Lives on the session's thread.
#pragma once

#include <functional>
#include <memory>

#include "actors/sessions/session_port.hpp"
#include "runtime/base/journal.hpp"
#include "script/dialogue/engine/conversation.hpp"
#include "script/dialogue/inputs/recording_port.hpp"
#include "script/dialogue/inputs/session_input.hpp"

namespace parlour::actors {

class SessionDialogue {
public:
  using MakePort = std::function<std::unique_ptr<SessionPort>()>;

  // Everything that enters is kept in the journal; null: nothing is.
  SessionDialogue(std::shared_ptr<const script::Program> program,
                  dialogue::ConversationOptions options, MakePort make_port,
                  std::shared_ptr<Journal> journal = nullptr);

  // The only way into the conversation.
  void take(dialogue::SessionInput input, Timestamp now);

  const dialogue::Conversation& conversation() const {
    return *conversation_;
  }
  SessionPort& port() {
    return *port_;
  }
  const SessionPort& port() const {
    return *port_;
  }

  // While an outcome is to come, which only the present port can hear, that one
  // stays. An error leaves all as it was.
  Expected<void> renew(Timestamp now);

  // What it has not read when it has ended.
  std::vector<Message> take_unread() {
    return conversation_->take_unread();
  }

private:
  // The port, as the conversation sees it.
  dialogue::Port& seen(SessionPort& port);
  void keep(const dialogue::TimedInput& input);

  const std::shared_ptr<const script::Program> program_;
  const dialogue::ConversationOptions options_;
  const MakePort make_port_;
  const std::shared_ptr<Journal> journal_; // null: none
  // Both before the conversation, which they outlive.
  std::unique_ptr<SessionPort> port_;
  std::unique_ptr<dialogue::RecordingPort> recording_; // null: no journal
  std::unique_ptr<dialogue::Conversation> conversation_;
};

} // namespace parlour::actors
