// InstanceDirectory: which components have not returned from a call, for who
// wants to stop the house.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace parlour::actors {

struct Instance; // actors/component.hpp

// Safe to use from any thread.
class InstanceDirectory {
public:
  void add(const std::shared_ptr<const Instance>& instance);
  // "Ear, Mouth"; those that were given up and have not returned included.
  std::string names_in_call() const;

private:
  mutable std::mutex mutex_;
  std::vector<std::weak_ptr<const Instance>> instances_;
};

} // namespace parlour::actors
