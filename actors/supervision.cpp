// The part of supervision that says what happens to running instances.
#include "actors/supervision.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/component_host.hpp"
#include "actors/supervisor.hpp"

namespace parlour::actors {

namespace {

// What libraries and models take to load.
constexpr Milliseconds start_deadline{30'000};

bool is_called_inline(const Component& component) {
  using enum Scope::Kind;
  const auto scope = component.order.upkeep.scope.kind;
  return component.description().is_inline &&
         (scope == usual || scope == in_turn);
}

// Keeps its whole instance.
std::shared_ptr<const InlinePlugin>
direct_of(const std::shared_ptr<Instance>& instance) {
  const auto* plugin =
      dynamic_cast<const InlinePlugin*>(instance->plugin.get());
  if (!plugin || !is_called_inline(*instance->component))
    return nullptr;
  return {instance, plugin};
}

std::size_t wanted_instances(const Component& component) {
  return component.order.upkeep.scope.instances;
}

} // namespace

// -- instances ----------------------------------------------------------------

std::vector<InstanceId>
Supervision::instances_of(const KeptPointer& kept) const {
  std::vector<InstanceId> ids;
  for (const auto& [id, entry] : entries_)
    if (entry.kept == kept)
      ids.push_back(id);
  return ids;
}

bool Supervision::is_kept(const KeptPointer& kept) const {
  const auto found = kept_.find(kept->component->name());
  return found != kept_.end() && found->second == kept;
}

bool Supervision::is_coming(const KeptPointer& kept) const {
  const auto found = coming_.find(kept->component->name());
  return found != coming_.end() && found->second == kept;
}

// Not before those that stop have stopped: both may want the same device.
void Supervision::make_missing(const KeptPointer& kept) {
  const auto ids = instances_of(kept);
  const bool one_stops = std::any_of(ids.begin(), ids.end(), [&](auto id) {
    return entries_[id].stage == Stage::stops;
  });
  if (kept->pauses || one_stops || closing_)
    return;
  for (auto i = ids.size(); i < wanted_instances(*kept->component); ++i)
    make_instance(kept);
}

void Supervision::make_instance(const KeptPointer& kept) {
  const auto& component = kept->component;
  auto instance = std::make_shared<Instance>();
  instance->id = ++last_instance_;
  instance->component = component;
  instance->door = std::make_shared<PluginDoor>(services_, component->name(),
                                                component->description().roles,
                                                instance->id);
  services_.instances.add(instance);
  auto host = host_for(instance);
  instance->door->belongs_to(host);
  instance->watch.expect(services_.work.begin());
  self_->send(host, start_component{});
  const auto id = instance->id;
  entries_[id] = {std::move(instance), std::move(host), kept, Stage::starts};
}

// In real time each has a thread of its own: one that hangs takes no other's.
component_host_actor
Supervision::host_for(const std::shared_ptr<Instance>& instance) {
  auto& system = self_->home_system();
  return services_.detaches
             ? system.spawn<caf::detached>(component_host, &services_, instance)
             : system.spawn(component_host, &services_, instance);
}

void Supervision::started(const instance_started& what) {
  const auto found = entries_.find(what.instance);
  if (found == entries_.end() || found->second.stage != Stage::starts)
    return;
  auto& entry = found->second;
  const auto kept = entry.kept;
  if (what.outcome)
    return works(entry);
  stop(entry);
  if (is_kept(kept))
    count_failure(kept, what.outcome.error().message);
  else if (is_coming(kept))
    came_not(kept, what.outcome.error());
}

void Supervision::works(Entry& entry) {
  entry.stage = Stage::works;
  entry.instance->watch.watch_anew();
  entry.kept->direct = direct_of(entry.instance);
  if (is_coming(entry.kept))
    came(entry.kept);
  else if (is_kept(entry.kept))
    joins(entry);
  else
    stop(entry);
}

// In the place of one that failed.
void Supervision::joins(const Entry& entry) {
  auto& component = *entry.kept->component;
  if (entry.kept->direct)
    publish_table(); // who asks in its own turn asks the new one
  component.mailbox->open();
  component.mailbox->join(entry.host);
  *component.up = true;
  tell_up(component);
}

void Supervision::stop(Entry& entry) {
  entry.stage = Stage::stops;
  entry.kept->component->mailbox->leave(entry.host);
  entry.instance->watch.expect(services_.work.begin());
  self_->send(entry.host, stop_component{});
}

void Supervision::close(Entry& entry, const std::string& reason) {
  answer_by_failure(entry.kept, entry.instance->door->close(), reason);
}

void Supervision::stopped(const instance_stopped& what) {
  remove(what.instance, "it was stopped");
}

void Supervision::remove(InstanceId id, const std::string& reason) {
  auto entry = entries_.extract(id);
  if (entry.empty())
    return;
  close(entry.mapped(), reason);
  after_end(entry.mapped().kept);
}

void Supervision::after_end(const KeptPointer& kept) {
  if (is_kept(kept))
    make_missing(kept);
  else if (const auto departure = departure_of(kept); departure != 0)
    gone(departure);
}

// -- failures -----------------------------------------------------------------

void Supervision::failed(const component_failed& what) {
  const auto found = entries_.find(what.instance);
  if (what.instance == 0) {
    if (const auto kept = kept_.find(what.name); kept != kept_.end())
      count_failure(kept->second, what.reason);
    return;
  }
  if (found == entries_.end() || found->second.stage == Stage::stops)
    return;
  auto& entry = found->second;
  const auto kept = entry.kept;
  stop(entry);
  close(entry, what.reason);
  if (is_kept(kept))
    count_failure(kept, what.reason);
  else if (is_coming(kept))
    came_not(kept, {ErrorKind::settings, what.reason, {}});
  else
    services_.log(what.name + " failed while it left: " + what.reason);
}

void Supervision::count_failure(const KeptPointer& kept,
                                const std::string& reason) {
  if (closing_)
    return;
  const auto& name = kept->component->name();
  const auto verdict = kept->failures.failed(services_.clock->now());
  services_.log(name + " failed: " + reason);
  tell("ComponentFailed", {name, reason, kept->failures.count()});
  kept->pauses = true;
  if (verdict.down)
    return rest(kept, reason, verdict.pause);
  kept->due = ticket(verdict.pause);
  try_later(kept, verdict.pause);
}

void Supervision::try_later(const KeptPointer& kept, Milliseconds pause) {
  kept->trial = ++last_number_;
  const actors::try_again again{kept->component->name(), kept->trial};
  if (pause > Milliseconds::zero())
    self_->delayed_send(self_, pause, again);
  else
    self_->send(self_, again);
}

// Its role falls to the next component of it.
void Supervision::rest(const KeptPointer& kept, const std::string& reason,
                       Milliseconds pause) {
  const auto& name = kept->component->name();
  *kept->component->up = false;
  kept->component->mailbox->close("is down");
  services_.log(name + " is down");
  for (auto id : instances_of(kept))
    if (auto& entry = entries_[id]; entry.stage != Stage::stops) {
      stop(entry);
      close(entry, reason);
    }
  answer_what_waits(kept, reason);
  tell("ComponentDown", {name, reason});
  try_later(kept, pause);
}

void Supervision::try_again(const actors::try_again& what) {
  const auto found = kept_.find(what.name);
  if (found == kept_.end() || found->second->trial != what.trial)
    return;
  const auto kept = found->second;
  kept->due = {};
  kept->pauses = false;
  make_missing(kept);
}

// -- calls that do not return -------------------------------------------------

void Supervision::watch(const watch_instance& what) {
  const auto found = entries_.find(what.instance);
  if (found == entries_.end())
    return;
  const auto& [instance, host, kept, stage] = found->second;
  auto deadline = kept->component->order.upkeep.deadline;
  if (stage == Stage::starts)
    deadline = std::max(deadline, start_deadline);
  std::optional left = deadline;
  if (!what.begins)
    left = instance->watch.look(services_.clock->now(), deadline);
  if (left && *left <= Milliseconds::zero())
    hangs(what.instance);
  else if (left)
    self_->delayed_send(self_, *left, watch_instance{what.instance, false});
}

// Its actor and its thread are left to themselves.
void Supervision::hangs(InstanceId id) {
  auto node = entries_.extract(id);
  auto& entry = node.mapped();
  const auto kept = entry.kept;
  const auto reason =
      "a call did not return within " +
      std::to_string(kept->component->order.upkeep.deadline.count()) + " ms";
  entry.instance->watch.give_up();
  kept->component->mailbox->leave(entry.host);
  close(entry, reason);
  if (is_coming(kept))
    came_not(kept, {ErrorKind::timeout, reason, {}});
  else if (is_kept(kept) && entry.stage != Stage::stops)
    count_failure(kept, reason);
  else
    services_.log(kept->component->name() + " does not stop: " + reason);
  after_end(kept);
}

// -- telling ------------------------------------------------------------------

void Supervision::tell(const char* event, std::vector<Value> params) {
  Message message;
  message.source = "System";
  message.command = event;
  message.params = std::move(params);
  services_.publish({std::move(message)});
}

void Supervision::tell_up(const Component& component) {
  const auto& roles = component.description().roles;
  tell("ComponentUp",
       {component.name(), roles.empty() ? Value() : Value(roles.front())});
}

void Supervision::answer_by_failure(const KeptPointer& kept,
                                    const std::vector<Message>& messages,
                                    const std::string& reason) {
  std::vector<Message> answers;
  for (const auto& message : messages)
    if (message.correlation != 0)
      answers.push_back(
          failure_answer(kept->component->name(), message, reason));
  if (!answers.empty() && !closing_)
    services_.publish(std::move(answers));
}

void Supervision::answer_what_waits(const KeptPointer& kept,
                                    const std::string& reason) {
  std::vector<Message> messages;
  for (auto& job : kept->component->mailbox->take_all())
    messages.push_back(std::move(job.message));
  answer_by_failure(kept, messages, reason);
}

// So that virtual time stops there, and nobody thinks that nothing is due.
DueTicket Supervision::ticket(Milliseconds delay) {
  const auto due = services_.clock->now() + delay.count();
  return {services_.due_times,
          services_.due_times.add(due, DueTimes::Of::component)};
}

} // namespace parlour::actors
