// SupervisionParts: what the supervisor of a node is made with. The node owns
// what is referred to here, and it outlives the supervisor.
#pragma once

#include <functional>
#include <memory>

#include "actors/components/instance/instance_directory.hpp"
#include "actors/components/instance/plugin_environment.hpp"
#include "actors/protocol/component_order.hpp"
#include "actors/routing/message_bus.hpp"
#include "actors/routing/session_directory.hpp"
#include "runtime/plugin/catalogue.hpp"

namespace parlour::actors {

// How components are made here.
// From NodeOptions and the program's settings (NodeRuntime::supervision_parts).
struct ComponentSettings {
  // What scripts can load; may be null.
  std::shared_ptr<PluginCatalogue> plugins = nullptr;
  // Completes what they load; may be empty.
  std::function<void(ComponentOrder&)> complete = {};
  // How long one may take to start, in real time.
  Milliseconds start_time{30'000};
  // How long a session waits for an answer.
  Milliseconds request_timeout{10'000};
  // Each instance gets a thread of its own.
  bool detaches = false;
};

struct SupervisionParts {
  NodeTime& time;
  MessageBus& bus;
  Observer& observer;
  const SessionDirectory& sessions;
  InstanceDirectory& instances;
  SharedEnvironment& environment; // of the plug-ins
  ComponentSettings settings = {};
};

} // namespace parlour::actors
