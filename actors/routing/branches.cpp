#include "actors/routing/branches.hpp"

#include <mutex>
#include <utility>

namespace parlour::actors {

void Branches::put(const SessionId& session, Branch branch) {
  std::unique_lock lock(mutex_);
  branches_[session] = std::move(branch);
}

void Branches::remove(const SessionId& session) {
  std::unique_lock lock(mutex_);
  branches_.erase(session);
}

std::optional<Branches::Branch> Branches::find(const SessionId& session) const {
  std::shared_lock lock(mutex_);
  const auto found = branches_.find(session);
  if (found == branches_.end())
    return std::nullopt;
  return found->second;
}

} // namespace parlour::actors
