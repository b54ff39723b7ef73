#include "actors/components/supervisor.hpp"

#include <caf/typed_event_based_actor.hpp>

namespace parlour::actors {

supervisor_actor::behavior_type
supervisor(supervisor_actor::stateful_pointer<supervisor_state> self,
           SupervisionParts parts) {
  self->state.supervision =
      std::make_unique<Supervision>(self, std::move(parts));
  auto* all = self->state.supervision.get();
  return {
      [=](const load_component& what) { all->load(what); },
      [=](const load_plugin& what) { all->load(what); },
      [=](const unload_component& what) { all->unload(what); },
      [=](const stop_components&) { all->stop_all(); },
      [=](const instance_started& what) { all->started(what); },
      [=](const instance_stopped& what) { all->stopped(what); },
      [=](const component_failed& what) { all->failed(what); },
      [=](const watch_instance& what) { all->watch(what); },
      [=](const instance_rests& what) { all->rests(what); },
      [=](const try_again& what) { all->try_again(what); },
      [=](const drain_over& what) { all->drain_over(what); },
      [=](const seat_opened& what) { all->opened(what); },
      [=](const session_begins& what) {
        all->begins(what);
        return session_settled{};
      },
      [=](const session_ended& what) { all->ended(what); },
  };
}

} // namespace parlour::actors
