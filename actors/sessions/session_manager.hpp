// The session manager: opens sessions at seats, knows them all, and notices
// when one is gone. A user turn that its session did not come to, or that came
// when it had ended, is taken to the seat's next session.
#pragma once

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "actors/routing/services.hpp"

namespace parlour::actors {

struct session_manager_state {
  static inline const char* name = "session_manager";
  struct Entry {
    session_actor session;
    seat_actor seat;
    std::vector<Subscription> subscriptions = {};
  };
  std::map<SessionId, Entry> sessions;     // a seat has one at a time
  std::map<std::string, seat_actor> seats; // by name
  // Those that ended last, and where: for turns that come too late for them.
  std::deque<std::pair<SessionId, seat_actor>> departed;
  bool closing = false;
};

session_manager_actor::behavior_type session_manager(
    session_manager_actor::stateful_pointer<session_manager_state> self,
    Services* services);

} // namespace parlour::actors
