// A component: one plug-in's object and the actor around it. What the plug-in
// throws ends neither the actor nor the house: the supervisor hears of it, the
// message is answered by Failed, and the next message is handled.
#pragma once

#include <atomic>
#include <set>

#include "actors/plugin_door.hpp"

namespace parlour::actors {

// Shared by the node, the routing table (for inline calls) and the host actor.
struct Component {
  std::string name;
  Options options;
  PluginDescription description;
  std::shared_ptr<PluginDoor> door; // before the plug-in: outlives it
  std::shared_ptr<IPlugin> plugin;
  std::shared_ptr<std::atomic<bool>> up =
      std::make_shared<std::atomic<bool>>(false);
  std::atomic<bool> at_work = false; // a call into the plug-in has not returned
};

struct component_host_state {
  static inline const char* name = "component_host";
  std::shared_ptr<Component> component;
  Services* services = nullptr;
  // That it has not called back for yet: CAF's clock holds their messages, and
  // tickets, until they are due, whether there still is a host or not.
  std::set<DueTimes::Id> delays;
  ~component_host_state();
};

component_host_actor::behavior_type component_host(
    component_host_actor::stateful_pointer<component_host_state> self,
    Services* services, std::shared_ptr<Component> component);

// The event that answers a message whose component failed.
Message failure_answer(const std::string& component, const Message& message,
                       const std::string& reason);

} // namespace parlour::actors
