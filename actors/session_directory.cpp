#include "actors/session_directory.hpp"

#include <mutex>
#include <utility>

namespace parlour::actors {

void SessionDirectory::add(const SessionId& id, session_actor session) {
  std::unique_lock lock(mutex_);
  sessions_[id] = std::move(session);
}

void SessionDirectory::remove(const SessionId& id) {
  std::unique_lock lock(mutex_);
  sessions_.erase(id);
}

void SessionDirectory::clear() {
  std::unique_lock lock(mutex_);
  sessions_.clear();
}

session_actor SessionDirectory::find(const SessionId& id) const {
  std::shared_lock lock(mutex_);
  auto found = sessions_.find(id);
  return found == sessions_.end() ? session_actor() : found->second;
}

std::vector<session_actor> SessionDirectory::all() const {
  std::shared_lock lock(mutex_);
  std::vector<session_actor> result;
  for (const auto& [id, session] : sessions_)
    result.push_back(session);
  return result;
}

} // namespace parlour::actors
