// OpenSessions: the sessions that the session manager knows, in the order in
// which they opened. What others see of them is the directory, which has the
// same ones: both change together, here.
#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "actors/routing/session_directory.hpp"
#include "runtime/message/subscription.hpp"

namespace parlour::actors {

// Used by the session manager alone; each finding takes about as long however
// many there are. An entry that was found stays where it is until it is
// removed.
class OpenSessions {
public:
  struct Entry {
    SessionId id;
    session_actor session;
    seat_actor seat; // has one session at a time
    std::vector<Subscription> subscriptions = {};
  };

  OpenSessions() = default; // until there is a directory
  explicit OpenSessions(SessionDirectory& directory) : directory_(&directory) {}

  void add(const SessionId& id, const session_actor& session,
           const seat_actor& seat);
  // What it was; nothing where there is none.
  std::optional<Entry> remove(const SessionId& id);
  // Null where there is none.
  Entry* find(const SessionId& id);
  Entry* find(caf::actor_id session);
  Entry* at(const seat_actor& seat);
  // By the ids of their actors, which rise.
  const std::map<caf::actor_id, Entry>& all() const {
    return sessions_;
  }

private:
  SessionDirectory* directory_ = nullptr;
  std::map<caf::actor_id, Entry> sessions_;
  std::unordered_map<caf::actor_id, caf::actor_id> at_seat_;
};

} // namespace parlour::actors
