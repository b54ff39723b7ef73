#include "actors/instance_directory.hpp"

#include "actors/component.hpp"

namespace parlour::actors {

void InstanceDirectory::add(const std::shared_ptr<const Instance>& instance) {
  std::lock_guard lock(mutex_);
  std::erase_if(instances_, [](const auto& one) { return one.expired(); });
  instances_.push_back(instance);
}

std::string InstanceDirectory::names_in_call() const {
  std::lock_guard lock(mutex_);
  std::string names;
  for (const auto& one : instances_)
    if (const auto instance = one.lock(); instance && instance->watch.in_call())
      names += (names.empty() ? "" : ", ") + instance->component->name();
  return names;
}

} // namespace parlour::actors
