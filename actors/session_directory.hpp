// SessionDirectory: which actor is which session, for those who deliver. The
// session manager writes it.
#pragma once

#include <map>
#include <shared_mutex>
#include <vector>

#include "runtime/interfaces.hpp"

namespace parlour::actors {

// Safe to use from any thread.
class SessionDirectory {
public:
  void add(const SessionId& id, session_actor session);
  void remove(const SessionId& id);
  void clear();
  // Null where there is none.
  session_actor find(const SessionId& id) const;
  std::vector<session_actor> all() const;

private:
  mutable std::shared_mutex mutex_;
  std::map<SessionId, session_actor> sessions_;
};

} // namespace parlour::actors
