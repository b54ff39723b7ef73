#include "actors/components/instance/instance_directory.hpp"

#include <optional>
#include <utility>

#include <caf/actor_cast.hpp>

#include "actors/components/instance/component_host.hpp"

namespace parlour::actors {

// What has expired goes when something is added, so that the list stays about
// as long as there are instances.
void InstanceDirectory::add(std::string name,
                            const std::shared_ptr<const CallWatchdog>& watch,
                            const component_host_actor& host) {
  std::lock_guard lock(mutex_);
  std::erase_if(entries_, [](const auto& one) { return one.watch.expired(); });
  entries_.push_back(
      {std::move(name), watch, caf::actor_cast<caf::weak_actor_ptr>(host)});
}

std::vector<ActorHandle> InstanceDirectory::handles() const {
  std::lock_guard lock(mutex_);
  std::vector<ActorHandle> all;
  for (const auto& one : entries_) {
    auto host = caf::actor_cast<caf::strong_actor_ptr>(one.host);
    if (!host)
      continue;
    all.push_back({component_host_state::name, one.name, std::move(host),
                   [weak = one.watch]() -> std::optional<Timestamp> {
                     const auto watch = weak.lock();
                     return watch ? watch->call_since() : std::nullopt;
                   }});
  }
  return all;
}

std::string InstanceDirectory::names_in_call() const {
  std::lock_guard lock(mutex_);
  std::string names;
  for (const auto& one : entries_)
    if (const auto watch = one.watch.lock(); watch && watch->in_call())
      names += (names.empty() ? "" : ", ") + one.name;
  return names;
}

} // namespace parlour::actors
