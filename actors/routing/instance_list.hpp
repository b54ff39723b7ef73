// InstanceList: of a component that has an instance for each seat or session,
// which one a session's messages go to. The supervisor writes it.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <vector>

#include "actors/routing/component_mailbox.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// The key is a session's id, or a seat's name: what a seat's components say
// between two sessions belongs to the seat.
class InstanceList {
public:
  struct Entry {
    std::shared_ptr<ComponentMailbox> mailbox;
    // False while it is down; shared.
    std::shared_ptr<const std::atomic<bool>> up;
  };

  void put(const SessionId& session, Entry entry);
  void remove(const SessionId& session);
  // Nothing where the session has none, or the message has no session.
  std::optional<Entry> find(const SessionId& session) const;
  // Of those that are up.
  std::vector<SessionId> sessions() const;

private:
  mutable std::shared_mutex mutex_;
  std::map<SessionId, Entry> entries_;
};

} // namespace parlour::actors
