// The session manager: opens sessions at seats, knows them all, and notices
// when one is gone.
#pragma once

#include <map>

#include "actors/services.hpp"

namespace parlour::actors {

struct session_manager_state {
  static inline const char* name = "session_manager";
  struct Entry {
    session_actor session;
    seat_actor seat;
  };
  std::map<SessionId, Entry> sessions;
};

session_manager_actor::behavior_type session_manager(
    session_manager_actor::stateful_pointer<session_manager_state> self,
    Services* services);

} // namespace parlour::actors
