// The message centre (paper III.A; engine rule 1): its table, which every
// sender applies itself (routing_table.hpp, Services::publish), and this actor,
// which gives to sessions what they get, and to queries what they asked for.
// What comes from outside of the house it routes as well.
#pragma once

#include "actors/routing/services.hpp"

namespace parlour::actors {

struct message_centre_state {
  static inline const char* name = "message_centre";
};

message_centre_actor::behavior_type message_centre(
    message_centre_actor::stateful_pointer<message_centre_state> self,
    Services* services);

} // namespace parlour::actors
