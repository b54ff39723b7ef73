// SessionDirectory: which actor is which session, for those who deliver, and
// at which seat. The session manager writes it.
#pragma once

#include <map>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "actors/protocol/interfaces.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// A handle that was found may be of a session that has just ended: such a
// session passes on what it is still sent, until the centre lets it go
// (message_centre.hpp).
class SessionDirectory {
public:
  void add(const SessionId& id, session_actor session, seat_actor seat = {});
  void remove(const SessionId& id);
  void clear();
  // Null where there is none.
  session_actor find(const SessionId& id) const;
  std::vector<session_actor> all() const;
  std::vector<std::pair<SessionId, session_actor>> all_by_id() const;
  // Each with its seat.
  std::vector<std::pair<SessionId, seat_actor>> seats() const;
  seat_actor seat_of(const SessionId& id) const;

private:
  mutable std::shared_mutex mutex_;
  struct Entry {
    session_actor session;
    seat_actor seat;
  };
  std::map<SessionId, Entry> sessions_;
};

} // namespace parlour::actors
