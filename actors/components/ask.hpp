// What a plug-in asks of another component (PluginHost::ask): one actor for
// each question, which sends it, waits for the event that ends it, and has the
// plug-in called back by its own door. It goes with the plug-in's host.
#pragma once

#include "actors/components/plugin_door.hpp"
#include "actors/routing/message_bus.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::actors {

struct ask_state {
  static inline const char* name = "ask";
  MessageBus* bus = nullptr;
  Correlation correlation = 0;
  ~ask_state();
};

struct AskOrder {
  Message request;
  Milliseconds patience{0};
  PluginHost::Reaction reaction;
  std::weak_ptr<PluginDoor> door;
  std::shared_ptr<const DueTicket> due; // of the answer, at the latest
  Work work;                            // until the component has been asked
};

query_actor::behavior_type ask(query_actor::stateful_pointer<ask_state> self,
                               MessageBus* bus, component_host_actor host,
                               AskOrder order);

} // namespace parlour::actors
