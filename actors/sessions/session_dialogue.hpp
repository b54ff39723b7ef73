// SessionDialogue: the conversation of a session, and the port by which it
// reaches others. It can be renewed: the conversation is written, and another
// one goes on from the bytes with a port of its own, as it would in another
// process. Lives on the session's thread.
#pragma once

#include <functional>
#include <memory>

#include "actors/sessions/session_port.hpp"
#include "script/dialogue/engine/conversation.hpp"

namespace parlour::actors {

class SessionDialogue {
public:
  using MakePort = std::function<std::unique_ptr<SessionPort>()>;

  SessionDialogue(std::shared_ptr<const script::Program> program,
                  dialogue::ConversationOptions options, MakePort make_port);

  dialogue::Conversation& conversation() {
    return *conversation_;
  }
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

private:
  Expected<std::unique_ptr<dialogue::Conversation>>
  go_on(SessionPort& port, const std::string& bytes) const;

  const std::shared_ptr<const script::Program> program_;
  const dialogue::ConversationOptions options_;
  const MakePort make_port_;
  std::unique_ptr<SessionPort> port_; // before the conversation: outlives it
  std::unique_ptr<dialogue::Conversation> conversation_;
};

} // namespace parlour::actors
