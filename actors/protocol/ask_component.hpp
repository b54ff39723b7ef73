// The message by which a component's plug-in asks another component
// (PluginHost::ask). Part of the supervisor's mailbox (interfaces.hpp).
#pragma once

#include <functional>
#include <memory>

#include <caf/actor_control_block.hpp>

#include "actors/protocol/due_times.hpp"
#include "actors/protocol/in_flight.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/message/message.hpp"

namespace parlour::actors {

// Spawn the actor that asks. The plug-in cannot: it may call from a thread of
// its own, and CAF's logger would belong to that thread from then on, so that
// the system could not end before the thread.
struct ask_component {
  caf::weak_actor_ptr host; // of the plug-in that asks
  Message request;
  Milliseconds patience{0};
  // Called on the asking actor's thread, once; not at all where the host ends
  // first.
  std::function<void(Expected<Message>)> finished;
  std::shared_ptr<const DueTicket> due; // of the answer, at the latest
  InFlight work;                        // until the component has been asked
};

} // namespace parlour::actors
