// What a plug-in asks of another component (PluginHost::ask): one actor for
// each question, which sends it, waits for the event that ends it, and hands
// the outcome over. It ends with the plug-in's host.
#pragma once

#include <functional>
#include <memory>

#include "actors/routing/message_bus.hpp"

namespace parlour::actors {

// The destructor forgets the correlation, whatever way the actor ends.
struct ask_state {
  static inline const char* name = "ask";
  MessageBus* bus = nullptr;
  Correlation correlation = 0;
  ~ask_state();
};

// What ComponentContext::ask hands over to the actor.
struct AskOrder {
  Message request;
  Milliseconds patience{0};
  // Called on this actor's thread, once; not at all where the host ends first.
  std::function<void(Expected<Message>)> finished;
  std::shared_ptr<const DueTicket> due; // of the answer, at the latest
  InFlight work;                        // until the component has been asked
};

query_actor::behavior_type ask(query_actor::stateful_pointer<ask_state> self,
                               MessageBus* bus, component_host_actor host,
                               AskOrder order);

} // namespace parlour::actors
