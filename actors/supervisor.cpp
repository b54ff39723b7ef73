#include "actors/supervisor.hpp"

#include <utility>

namespace parlour::actors {

supervisor_actor::behavior_type
supervisor(supervisor_actor::stateful_pointer<supervisor_state> self,
           Services* services) {
  return {
      [=](const component_failed& what) {
        const auto count = ++self->state.failures[what.name];
        services->log(what.name + " failed: " + what.reason);
        Message event;
        event.source = "System";
        event.command = "ComponentFailed";
        event.params = {what.name, what.reason, count};
        self->send(services->centre, publish{{std::move(event)}, what.work});
      },
  };
}

} // namespace parlour::actors
