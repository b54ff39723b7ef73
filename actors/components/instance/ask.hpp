// What a plug-in asks of another component (PluginHost::ask): one actor for
// each question, which sends it, waits for the event that ends it, and hands
// the outcome over. It ends with the plug-in's host.
#pragma once

#include "actors/routing/message_bus.hpp"

namespace parlour::actors {

// The destructor forgets the correlation, whatever way the actor ends.
struct ask_state {
  static inline const char* name = "ask";
  MessageBus* bus = nullptr;
  Correlation correlation = 0;
  ~ask_state();
};

query_actor::behavior_type ask(query_actor::stateful_pointer<ask_state> self,
                               MessageBus* bus, component_host_actor host,
                               ask_component order);

} // namespace parlour::actors
