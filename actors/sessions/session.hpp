// A session: one conversation, its mailbox and its thread of time. The
// dialogue is decided in script/dialogue; here is only when it is asked.
#pragma once

#include <memory>

#include "actors/sessions/session_port.hpp"
#include "script/dialogue/engine/conversation.hpp"

namespace parlour::actors {

struct SessionOrder {
  SessionId id;
  std::uint64_t seed = 1;
  seat_actor seat;
};

struct session_state {
  static inline const char* name = "session";
  std::shared_ptr<const SessionParts> parts;
  NodeTime* time = nullptr;
  std::unique_ptr<SessionPort> port; // before the conversation: outlives it
  std::unique_ptr<dialogue::Conversation> conversation;
  bool stepping = false;     // a take_step is in the mailbox
  bool waits = false;        // as the work count knows it
  bool asked_to_end = false; // from outside: nothing goes on after it
  ~session_state();
};

session_actor::behavior_type
session(session_actor::stateful_pointer<session_state> self,
        std::shared_ptr<const SessionParts> parts, SessionOrder order);

// One request to a topic's frame; its answer is the session's next input,
// before whatever else is in the mailbox.
void ask_frame(session_actor::stateful_pointer<session_state> self,
               const topic_frame_actor& frame,
               std::shared_ptr<const dialogue::FrameRequest> request);

} // namespace parlour::actors
