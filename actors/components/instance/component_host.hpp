// The host of one instance: the actor, and in real time mostly the thread, that
// calls its plug-in. An exception of the plug-in ends neither the actor nor the
// node: the supervisor hears of it and starts another instance.
//
// A call that does not return is given up from outside (call_watchdog.hpp). If
// it returns after all, its results are dropped and the actor quits.
#pragma once

#include "actors/components/instance/component.hpp"
#include "actors/support/actor_trace.hpp"

namespace parlour::actors {

struct HostParts {
  NodeTime* time = nullptr;
  Observer* observer = nullptr;
  supervisor_actor supervisor;
  bool has_thread = false; // of its own
};

// All of it is used on the host's thread alone; what others share is in the
// instance.
struct component_host_state {
  static inline const char* name = "component_host";
  HostParts parts;
  std::shared_ptr<Instance> instance;
  ActorTrace trace;
};

component_host_actor::behavior_type component_host(
    component_host_actor::stateful_pointer<component_host_state> self,
    HostParts parts, std::shared_ptr<Instance> instance);

} // namespace parlour::actors
