#include "actors/routing/instance_list.hpp"

#include <mutex>
#include <utility>

namespace parlour::actors {

void InstanceList::put(const SessionId& session, Entry entry) {
  std::unique_lock lock(mutex_);
  entries_[session] = std::move(entry);
}

void InstanceList::remove(const SessionId& session) {
  std::unique_lock lock(mutex_);
  entries_.erase(session);
}

// By value: the entry may be removed while its mailbox is still used.
std::optional<InstanceList::Entry>
InstanceList::find(const SessionId& session) const {
  std::shared_lock lock(mutex_);
  const auto found = entries_.find(session);
  if (found == entries_.end())
    return std::nullopt;
  return found->second;
}

std::vector<SessionId> InstanceList::sessions() const {
  std::vector<SessionId> sessions;
  const std::shared_lock lock(mutex_);
  for (const auto& [session, entry] : entries_)
    if (*entry.up)
      sessions.push_back(session);
  return sessions;
}

} // namespace parlour::actors
