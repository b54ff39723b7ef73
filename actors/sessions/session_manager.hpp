// The session manager: opens sessions at seats, knows them all, and notices
// when one is gone. A user turn that its session did not come to, or that came
// when it had ended, is taken to the seat's next session. Brings the sessions
// over to changed scripts.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <unordered_map>
#include <utility>

#include "actors/sessions/open_sessions.hpp"
#include "actors/sessions/rest_round.hpp"
#include "actors/sessions/session_parts.hpp"
#include "runtime/base/text/text_map.hpp"

namespace parlour::actors {

// Of the sessions that open; called by the session manager only.
// By a seed of the run both are the same each time (id_source.hpp).
struct SessionNames {
  std::function<SessionId()> next_id;
  std::function<std::uint64_t()> next_seed;
};

struct session_manager_state {
  static inline const char* name = "session_manager";
  OpenSessions sessions;
  TextMap<seat_actor> seats;  // by name
  TextMap<seat_actor> visits; // those of them that come and go
  // Those that leave when their session has ended, by the ids of their actors.
  std::unordered_map<caf::actor_id, std::string> closing_seats;
  // Those that ended last, and where: for turns that come too late for them.
  std::deque<std::pair<SessionId, seat_actor>> departed;
  RestRound resting;
  bool closing = false;
  std::string last_error;
  std::shared_ptr<const SessionParts> parts;
  SessionDirectory* directory = nullptr;
  SessionNames names;
};

session_manager_actor::behavior_type session_manager(
    session_manager_actor::stateful_pointer<session_manager_state> self,
    SessionParts parts, SessionDirectory* directory, SessionNames names);

} // namespace parlour::actors
