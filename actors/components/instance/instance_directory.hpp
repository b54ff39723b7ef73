// InstanceDirectory: the instances that there are, for who asks how they are:
// those, too, that were given up in a call and have not returned.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "actors/support/call_watchdog.hpp"

namespace parlour::actors {

// Safe to use from any thread.
// The supervisor adds; `parlour status` and the node's end ask. Nobody removes:
// an entry is over when its instance is.
class InstanceDirectory {
public:
  // `watch` lives as long as the instance.
  void add(std::string name, const std::shared_ptr<const CallWatchdog>& watch,
           const component_host_actor& host = {});
  // Their hosts.
  std::vector<ActorHandle> handles() const;
  // "Ear, Mouth"; those that were given up and have not returned included.
  std::string names_in_call() const;

private:
  struct Entry {
    std::string name;
    std::weak_ptr<const CallWatchdog> watch;
    caf::weak_actor_ptr host; // weak: it holds the plug-in
  };
  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
};

} // namespace parlour::actors
