// The supervisor: hears of every component that failed, counts it, shows it,
// and tells the sessions (System.ComponentFailed).
#pragma once

#include <map>

#include "actors/services.hpp"

namespace parlour::actors {

struct supervisor_state {
  static inline const char* name = "supervisor";
  std::map<std::string, std::int64_t> failures; // by component
};

supervisor_actor::behavior_type
supervisor(supervisor_actor::stateful_pointer<supervisor_state> self,
           Services* services);

} // namespace parlour::actors
