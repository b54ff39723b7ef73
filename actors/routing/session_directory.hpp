// SessionDirectory: which actor is which session, for those who deliver, and
// at which seat. The session manager writes it.
#pragma once

#include <shared_mutex>
#include <vector>

#include "actors/protocol/interfaces.hpp"
#include "runtime/base/text/text_map.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// A handle that was found may be of a session that has just ended: such a
// session passes on what it is still sent, until the centre lets it go
// (message_centre.hpp).
class SessionDirectory {
public:
  struct Entry {
    SessionId id;
    session_actor session;
    seat_actor seat;
  };

  void add(const SessionId& id, session_actor session, seat_actor seat = {});
  void remove(const SessionId& id);
  void clear();
  // Null where there is none.
  session_actor find(const SessionId& id) const;
  // In the order of their ids.
  std::vector<Entry> all() const;
  seat_actor seat_of(const SessionId& id) const;

private:
  struct Actors {
    session_actor session;
    seat_actor seat;
  };

  mutable std::shared_mutex mutex_;
  TextMap<Actors> sessions_;
};

} // namespace parlour::actors
