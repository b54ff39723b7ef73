// The supervisor: hears of every call into a component that threw, counts it,
// shows it, and tells the sessions (System.ComponentFailed).
//
// It does nothing else yet: a component that hangs has no deadline, one that
// floods no credit; none is restarted, and one that fails again and again stays
// the first of its role (there is no System.ComponentDown).
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
