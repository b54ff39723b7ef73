#include "actors/routing/instance_directory.hpp"

#include <utility>

namespace parlour::actors {

void InstanceDirectory::add(std::string name,
                            const std::shared_ptr<const CallWatch>& watch) {
  std::lock_guard lock(mutex_);
  std::erase_if(entries_, [](const auto& one) { return one.watch.expired(); });
  entries_.push_back({std::move(name), watch});
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
