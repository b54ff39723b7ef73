#include "actors/component_host.hpp"

#include <optional>
#include <string>
#include <utility>

#include "actors/thrown.hpp"

namespace parlour::actors {

namespace {

using Self = component_host_actor::stateful_pointer<component_host_state>;

void report(Self self, const std::string& reason, Work work) {
  self->send(
      self->state.services->supervisor,
      component_failed{self->state.component->name, reason, std::move(work)});
}

// What the plug-in throws when it is called, in words.
template <class Action>
std::optional<std::string> thrown_by_plugin(Component& component,
                                            Action&& action) {
  component.at_work = true;
  auto thrown = thrown_by(std::forward<Action>(action));
  component.at_work = false;
  return thrown;
}

void start(Self self, const start_component& what) {
  auto& component = *self->state.component;
  Expected<void> outcome;
  auto thrown = thrown_by_plugin(component, [&] {
    outcome = component.plugin->start(*component.door, component.options);
  });
  if (thrown)
    outcome = fail(ErrorKind::settings, *thrown);
  *component.up = outcome.has_value();
  what.done(std::move(outcome));
}

void handle(Self self, const handle_message& what) {
  auto& component = *self->state.component;
  auto reason = thrown_by_plugin(
      component, [&] { component.plugin->receive(what.message); });
  if (!reason)
    return;
  report(self, *reason, what.work);
  if (what.message.correlation != 0)
    self->send(self->state.services->centre,
               publish{{failure_answer(component.name, what.message, *reason)},
                       what.work});
}

void put_off(Self self, const run_after& what) {
  self->state.delays.insert(what.due->id());
  if (what.delay > Milliseconds::zero())
    self->delayed_send(self, what.delay, run_now{what.due, what.action});
  else
    self->send(self, run_now{what.due, what.action});
}

void call_back(Self self, const run_now& what) {
  auto& due_times = self->state.services->due_times;
  const auto due = what.due->id();
  self->state.delays.erase(due);
  if (!due_times.has(due))
    return; // cancelled
  auto work = self->state.services->work.begin();
  if (auto reason = thrown_by_plugin(*self->state.component, what.action))
    report(self, *reason, work);
  due_times.remove(due);
}

void stop(Self self) {
  auto& component = *self->state.component;
  *component.up = false;
  if (auto reason =
          thrown_by_plugin(component, [&] { component.plugin->stop(); }))
    self->state.services->log(component.name +
                              " did not stop well: " + *reason);
  self->quit();
}

} // namespace

component_host_state::~component_host_state() {
  for (auto due : delays)
    services->due_times.remove(due);
}

Message failure_answer(const std::string& component, const Message& message,
                       const std::string& reason) {
  Message event;
  event.source = component;
  event.command = "Failed";
  event.params = {reason};
  event.session = message.session;
  event.correlation = message.correlation;
  return event;
}

component_host_actor::behavior_type component_host(
    component_host_actor::stateful_pointer<component_host_state> self,
    Services* services, std::shared_ptr<Component> component) {
  self->state.services = services;
  self->state.component = std::move(component);
  return {
      [=](const start_component& what) { start(self, what); },
      [=](const handle_message& what) { handle(self, what); },
      [=](const run_after& what) { put_off(self, what); },
      [=](const run_now& what) { call_back(self, what); },
      [=](const stop_component&) { stop(self); },
  };
}

} // namespace parlour::actors
