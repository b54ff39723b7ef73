// The messages by which a component's host calls its plug-in. Part of the
// host's mailbox (interfaces.hpp).
#pragma once

#include <functional>
#include <memory>

#include "actors/protocol/due_times.hpp"
#include "actors/protocol/in_flight.hpp"
#include "runtime/base/clock.hpp"

namespace parlour::actors {

// Make and start the plug-in; instance_started follows.
struct start_component {};
// The component_mailbox is no longer empty: take messages from it.
struct mailbox_ready {};
// The plug-in wants to be called back after a delay. `action` is its own code,
// which only the host's thread may run, so it has to be a function. `due` goes
// with the message if no host takes it.
struct run_after {
  Milliseconds delay;
  std::shared_ptr<const DueTicket> due;
  std::function<void()> action;
  InFlight work;
};
// The delay of a run_after is over; the host sends this to itself.
struct run_now {
  std::shared_ptr<const DueTicket> due;
  std::function<void()> action;
};
// Stop the plug-in and end; instance_stopped follows.
struct stop_component {};

} // namespace parlour::actors
