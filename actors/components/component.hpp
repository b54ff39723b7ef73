// A component and its instances. The component has a name, a place among those
// of its roles, and a mailbox, and outlives its instances; each of these is a
// plug-in's object with an actor of its own around it (component_host).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "actors/components/component_order.hpp"
#include "actors/components/plugin_door.hpp"
#include "actors/support/call_watch.hpp"

namespace parlour::actors {

struct Component {
  ComponentOrder order;
  std::shared_ptr<ComponentMailbox> mailbox;
  // False before it has started and while it is down; shared with the table.
  std::shared_ptr<std::atomic<bool>> up =
      std::make_shared<std::atomic<bool>>(false);

  const std::string& name() const {
    return order.name;
  }
  const PluginDescription& description() const {
    return order.factory.description;
  }
};

struct Instance {
  InstanceId id = 0;
  std::shared_ptr<const Component> component;
  std::shared_ptr<PluginDoor> door; // before the plug-in: outlives it
  std::shared_ptr<IPlugin> plugin;  // made by its host, on its thread
  CallWatch watch;
  // Set when it is to go as soon as it has nothing to do.
  std::atomic<bool> leaves = false;
};

} // namespace parlour::actors
