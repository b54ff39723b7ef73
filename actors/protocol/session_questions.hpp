// What a tool asks a session from outside: a slot's value, or the name of the
// active state. Part of a session's mailbox (interfaces.hpp).
#pragma once

#include <string>

#include "actors/protocol/in_flight.hpp"
#include "runtime/base/value.hpp"

namespace parlour::actors {

struct get_slot {
  std::string topic;
  std::string slot;
  InFlight work;
};
struct slot_told {
  Value value; // unknown where there is no such slot
};
struct get_state {
  InFlight work;
};
struct state_told {
  std::string state; // empty where none is active
};

} // namespace parlour::actors
