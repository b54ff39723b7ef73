// The host of one instance: the actor, and in real time mostly the thread, that
// calls its plug-in. What the plug-in throws ends neither the actor nor the
// house: the supervisor hears of it and puts another instance in its place.
//
// A call that does not return is given up from outside (call_watch.hpp): when
// it returns after all, nobody hears of it, and the actor ends.
#pragma once

#include "actors/components/component.hpp"

namespace parlour::actors {

struct HostParts {
  NodeTime* time = nullptr;
  Observer* observer = nullptr;
  supervisor_actor supervisor;
  bool has_thread = false; // of its own
};

struct component_host_state {
  static inline const char* name = "component_host";
  HostParts parts;
  std::shared_ptr<Instance> instance;
};

component_host_actor::behavior_type component_host(
    component_host_actor::stateful_pointer<component_host_state> self,
    HostParts parts, std::shared_ptr<Instance> instance);

} // namespace parlour::actors
