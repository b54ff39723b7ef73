// InstanceDirectory: which components have not returned from a call, for who
// wants to stop the house.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "actors/support/call_watch.hpp"

namespace parlour::actors {

// Safe to use from any thread.
class InstanceDirectory {
public:
  // `watch` lives as long as the instance.
  void add(std::string name, const std::shared_ptr<const CallWatch>& watch);
  // "Ear, Mouth"; those that were given up and have not returned included.
  std::string names_in_call() const;

private:
  struct Entry {
    std::string name;
    std::weak_ptr<const CallWatch> watch;
  };
  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
};

} // namespace parlour::actors
