// A session: one conversation with its mailbox, which makes it free of races:
// one input at a time, in order. What an input means is decided in
// script/dialogue; here is only when it is handed over. Spawned and monitored
// by the session manager; what its handlers throw ends this session alone.
#pragma once

#include <memory>

#include "actors/sessions/session_dialogue.hpp"
#include "actors/sessions/turn_meter.hpp"

namespace parlour::actors {

// `seed` decides all that is random in the conversation, so that a replay draws
// the same.
struct SessionOrder {
  SessionId id;
  std::uint64_t seed = 1;
  seat_actor seat;
  std::shared_ptr<const dialogue::SavedSession> saved = nullptr; // null: new
  std::string seat_name = {}; // of a configured one; empty: of another
};

// Used by the session's actor alone. `parts` and `time` outlive it.
struct session_state {
  static inline const char* name = "session";
  std::shared_ptr<const SessionParts> parts;
  NodeTime* time = nullptr;
  std::unique_ptr<SessionDialogue> dialogue;
  // Until it begins; null: it is a new one.
  std::shared_ptr<const dialogue::SavedSession> saved;
  DueTicket scripts_due; // when it no longer waits to change its program
  TurnMeter meter;
  bool stepping = false;     // a take_step is in the mailbox
  bool waits = false;        // as the work count knows it
  bool asked_to_end = false; // from outside: nothing goes on after it
  ~session_state();
};

session_actor::behavior_type
session(session_actor::stateful_pointer<session_state> self,
        std::shared_ptr<const SessionParts> parts, SessionOrder order);

} // namespace parlour::actors
