#include "actors/components/supervisor.hpp"

#include <caf/typed_event_based_actor.hpp>

#include "actors/components/instance/ask.hpp"
#include "actors/support/actor_trace.hpp"
#include "actors/support/tell_status.hpp"

namespace parlour::actors {

namespace {

// Nobody is there to be called back where the host has ended.
void spawn_ask(supervisor_actor::pointer self, MessageBus* bus,
               const ask_component& order) {
  if (auto host = caf::actor_cast<caf::strong_actor_ptr>(order.host))
    self->spawn(ask, bus, caf::actor_cast<component_host_actor>(host), order);
}

} // namespace

// What takes its time is answered by a promise, which CAF returns as "not
// answered yet"; the rest is one call each.
supervisor_actor::behavior_type
supervisor(supervisor_actor::stateful_pointer<supervisor_state> self,
           SupervisionParts parts) {
  auto& observer = parts.observer;
  auto* bus = &parts.bus;
  self->state.supervision =
      std::make_unique<Supervision>(self, std::move(parts));
  auto* all = self->state.supervision.get();
  return traced<supervisor_actor::behavior_type>(
      ActorTrace(observer, supervisor_state::name, ""),
      [=](const load_component& what) {
        auto promise = self->make_response_promise<component_done>();
        all->load(what, promise);
        return promise;
      },
      [=](const load_plugin& what) {
        auto promise = self->make_response_promise<component_done>();
        all->load(what, promise);
        return promise;
      },
      [=](const unload_component& what) {
        auto promise = self->make_response_promise<component_done>();
        all->unload(what, promise);
        return promise;
      },
      [=](const stop_components&) { all->stop_all(); },
      [=](const instance_started& what) { all->started(what); },
      [=](const instance_stopped& what) { all->stopped(what); },
      [=](const component_failed& what) { all->failed(what); },
      [=](const component_available& what) { all->available(what); },
      [=](const watch_instance& what) { all->watch(what); },
      [=](const instance_idle& what) { all->idle(what); },
      [=](const try_again& what) { all->try_again(what); },
      [=](const ask_component& what) { spawn_ask(self, bus, what); },
      [=](const drain_over& what) { all->drain_over(what); },
      [=](const seat_opened& what) { all->opened(what); },
      [=](const seat_closed& what) { all->closed(what); },
      [=](const session_begins& what) {
        all->begins(what);
        return session_settled{};
      },
      [=](const session_ended& what) { all->ended(what); },
      [=](const change_environment& what) { return all->change(what); },
      [=](const get_status& what) {
        return tell_status(self, what, {{}, all->doing(), all->last_error()});
      });
}

} // namespace parlour::actors
