// The supervisor: the actor around Supervision, which says what it does.
#pragma once

#include <memory>

#include "actors/components/supervision.hpp"

namespace parlour::actors {

struct supervisor_state {
  static inline const char* name = "supervisor";
  std::unique_ptr<Supervision> supervision;
};

supervisor_actor::behavior_type
supervisor(supervisor_actor::stateful_pointer<supervisor_state> self,
           SupervisionParts parts);

} // namespace parlour::actors
