// The message centre: every event passes here on its way to components and
// sessions (paper III.A; engine rule 1). What sessions post, they send by the
// same table themselves.
#pragma once

#include "actors/services.hpp"

namespace parlour::actors {

struct message_centre_state {
  static inline const char* name = "message_centre";
};

message_centre_actor::behavior_type message_centre(
    message_centre_actor::stateful_pointer<message_centre_state> self,
    Services* services);

} // namespace parlour::actors
