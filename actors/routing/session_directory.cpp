#include "actors/routing/session_directory.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace parlour::actors {

void SessionDirectory::add(const SessionId& id, session_actor session,
                           seat_actor seat) {
  std::unique_lock lock(mutex_);
  sessions_[id] = {std::move(session), std::move(seat)};
}

void SessionDirectory::remove(const SessionId& id) {
  std::unique_lock lock(mutex_);
  sessions_.erase(id);
}

void SessionDirectory::clear() {
  std::unique_lock lock(mutex_);
  sessions_.clear();
}

// Readers share the lock: every delivery to a session asks here.
session_actor SessionDirectory::find(const SessionId& id) const {
  std::shared_lock lock(mutex_);
  auto found = sessions_.find(id);
  return found == sessions_.end() ? session_actor() : found->second.session;
}

std::vector<SessionDirectory::Entry> SessionDirectory::all() const {
  std::vector<Entry> result;
  {
    std::shared_lock lock(mutex_);
    for (const auto& [id, actors] : sessions_)
      result.push_back({id, actors.session, actors.seat});
  }
  std::ranges::sort(result, {}, &Entry::id);
  return result;
}

seat_actor SessionDirectory::seat_of(const SessionId& id) const {
  std::shared_lock lock(mutex_);
  auto found = sessions_.find(id);
  return found == sessions_.end() ? seat_actor() : found->second.seat;
}

} // namespace parlour::actors
