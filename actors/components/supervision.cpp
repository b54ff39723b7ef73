// The part of supervision that says what happens to running instances.
#include "actors/components/supervision.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/components/component_host.hpp"
#include "actors/components/supervisor.hpp"

namespace parlour::actors {

namespace {

bool is_called_inline(const Component& component) {
  using enum Scope::Kind;
  const auto scope = component.order.upkeep.scope.kind;
  return component.description().is_inline && !component.description().blocks &&
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

std::vector<InstanceId> Supervision::instances_of(const Branch& branch) const {
  std::vector<InstanceId> ids;
  for (const auto& [id, entry] : entries_)
    if (entry.branch.get() == &branch)
      ids.push_back(id);
  return ids;
}

bool Supervision::is_kept(const BranchPointer& branch) const {
  const auto found = kept_.find(branch->name());
  return found != kept_.end() && has(*found->second, branch);
}

// What it comes with; null: it does not.
Supervision::KeptPointer
Supervision::is_coming(const BranchPointer& branch) const {
  const auto found = coming_.find(branch->name());
  return found != coming_.end() && has(*found->second, branch) ? found->second
                                                               : nullptr;
}

bool Supervision::has(const Kept& kept, const BranchPointer& branch) {
  const auto found = kept.branches.find(branch->place->name());
  return found != kept.branches.end() && found->second == branch;
}

// Not before those that stop have stopped: both may want the same device.
void Supervision::make_missing(const BranchPointer& branch) {
  const auto ids = instances_of(*branch);
  const bool one_stops = std::any_of(ids.begin(), ids.end(), [&](auto id) {
    return entries_[id].stage == Stage::stops;
  });
  if (branch->pauses || one_stops || closing_)
    return;
  for (auto i = ids.size(); i < wanted_instances(*branch->component); ++i)
    make_instance(branch);
}

void Supervision::make_instance(const BranchPointer& branch) {
  const auto& component = branch->component;
  auto instance = std::make_shared<Instance>();
  instance->id = ++last_instance_;
  instance->component = component;
  instance->door = std::make_shared<PluginDoor>(
      door_parts(), component->name(), component->description(), instance->id,
      branch->place == house_ ? nullptr : branch->place);
  parts_.instances.add(component->name(), {instance, &instance->watch});
  auto host = host_for(instance);
  instance->door->belongs_to(host);
  instance->watch.expect(parts_.time.work.begin());
  self_->send(host, start_component{});
  const auto id = instance->id;
  entries_[id] = {std::move(instance), std::move(host), branch, Stage::starts};
}

DoorParts Supervision::door_parts() const {
  return {parts_.time, parts_.bus, parts_.observer, parts_.environment,
          supervisor_actor(self_)};
}

// In real time each has a thread of its own: one that hangs takes no other's.
component_host_actor
Supervision::host_for(const std::shared_ptr<Instance>& instance) {
  auto& system = self_->home_system();
  HostParts parts{&parts_.time, &parts_.observer, supervisor_actor(self_),
                  parts_.settings.detaches};
  return parts.has_thread
             ? system.spawn<caf::detached>(component_host, std::move(parts),
                                           instance)
             : system.spawn(component_host, std::move(parts), instance);
}

void Supervision::started(const instance_started& what) {
  const auto found = entries_.find(what.instance);
  if (found == entries_.end() || found->second.stage != Stage::starts)
    return;
  auto& entry = found->second;
  const auto branch = entry.branch;
  if (what.outcome)
    return works(entry);
  stop(entry);
  if (is_kept(branch))
    count_failure(branch, what.outcome.error().message);
  else if (const auto kept = is_coming(branch))
    came_not(kept, what.outcome.error());
}

void Supervision::works(Entry& entry) {
  entry.stage = Stage::works;
  entry.instance->watch.watch_anew();
  entry.branch->direct = direct_of(entry.instance);
  if (const auto kept = is_coming(entry.branch))
    came(kept);
  else if (is_kept(entry.branch))
    joins(entry);
  else
    stop(entry);
}

// In the place of one that failed, or as the first of its session or seat.
void Supervision::joins(const Entry& entry) {
  const auto& branch = *entry.branch;
  auto& component = *branch.component;
  if (branch.direct)
    publish_table(); // who asks in its own turn asks the new one
  component.mailbox->open();
  component.mailbox->join(entry.host);
  *component.up = true;
  if (branch.failures.count() != 0)
    tell_up(component, branch.place->session());
}

void Supervision::stop(Entry& entry) {
  entry.stage = Stage::stops;
  entry.branch->component->mailbox->leave(entry.host);
  entry.instance->watch.expect(parts_.time.work.begin());
  self_->send(entry.host, stop_component{});
}

void Supervision::close(Entry& entry, const std::string& reason) {
  answer_by_failure(*entry.branch, entry.instance->door->close(), reason);
}

void Supervision::stopped(const instance_stopped& what) {
  remove(what.instance, "it was stopped");
}

void Supervision::remove(InstanceId id, const std::string& reason) {
  auto entry = entries_.extract(id);
  if (entry.empty())
    return;
  close(entry.mapped(), reason);
  after_end(entry.mapped().branch);
}

void Supervision::after_end(const BranchPointer& branch) {
  if (is_kept(branch))
    make_missing(branch);
  else if (const auto departure = departure_of(branch); departure != 0)
    gone(departure);
}

// -- failures -----------------------------------------------------------------

void Supervision::failed(const component_failed& what) {
  const auto found = entries_.find(what.instance);
  if (what.instance == 0) {
    if (const auto kept = kept_.find(what.name); kept != kept_.end())
      if (const auto house = kept->second->branches.find(house_->name());
          house != kept->second->branches.end())
        count_failure(house->second, what.reason);
    return;
  }
  if (found == entries_.end() || found->second.stage == Stage::stops)
    return;
  auto& entry = found->second;
  const auto branch = entry.branch;
  stop(entry);
  close(entry, what.reason);
  if (is_kept(branch))
    count_failure(branch, what.reason);
  else if (const auto kept = is_coming(branch))
    came_not(kept, {ErrorKind::settings, what.reason, {}});
  else
    parts_.observer.log(what.name + " failed while it left: " + what.reason);
}

void Supervision::count_failure(const BranchPointer& branch,
                                const std::string& reason) {
  if (closing_)
    return;
  const auto verdict = branch->failures.failed(parts_.time.now());
  parts_.observer.log(branch->name() + " failed: " + reason);
  tell("ComponentFailed", {branch->name(), reason, branch->failures.count()},
       branch->place->session());
  branch->pauses = true;
  if (verdict.down)
    return rest(branch, reason, verdict.pause);
  branch->due = ticket(verdict.pause);
  try_later(*branch, verdict.pause);
}

void Supervision::try_later(Branch& branch, Milliseconds pause) {
  branch.trial = ++last_number_;
  const actors::try_again again{branch.name(), branch.place->name(),
                                branch.trial};
  if (pause > Milliseconds::zero())
    self_->delayed_send(self_, pause, again);
  else
    self_->send(self_, again);
}

// Its role falls to the next component of it.
void Supervision::rest(const BranchPointer& branch, const std::string& reason,
                       Milliseconds pause) {
  *branch->component->up = false;
  branch->component->mailbox->close("is down");
  parts_.observer.log(branch->name() + " is down");
  for (auto id : instances_of(*branch))
    if (auto& entry = entries_[id]; entry.stage != Stage::stops) {
      stop(entry);
      close(entry, reason);
    }
  answer_what_waits(*branch, reason);
  tell("ComponentDown", {branch->name(), reason}, branch->place->session());
  try_later(*branch, pause);
}

void Supervision::try_again(const actors::try_again& what) {
  const auto kept = kept_.find(what.name);
  if (kept == kept_.end())
    return;
  const auto found = kept->second->branches.find(what.place);
  if (found == kept->second->branches.end() ||
      found->second->trial != what.trial)
    return;
  const auto branch = found->second;
  branch->due = {};
  branch->pauses = false;
  make_missing(branch);
}

// -- calls that do not return -------------------------------------------------

Milliseconds Supervision::deadline_of(const Entry& entry) const {
  const auto deadline = entry.branch->component->order.upkeep.deadline;
  return entry.stage == Stage::starts
             ? std::max(deadline, parts_.settings.start_time)
             : deadline;
}

void Supervision::watch(const watch_instance& what) {
  const auto found = entries_.find(what.instance);
  if (found == entries_.end())
    return;
  const auto& instance = found->second.instance;
  const auto deadline = deadline_of(found->second);
  std::optional left = deadline;
  if (!what.begins)
    left = instance->watch.look(parts_.time.now(), deadline);
  if (left && *left <= Milliseconds::zero())
    hangs(what.instance);
  else if (left)
    self_->delayed_send(self_, *left, watch_instance{what.instance, false});
}

// Its actor and its thread are left to themselves.
void Supervision::hangs(InstanceId id) {
  auto node = entries_.extract(id);
  auto& entry = node.mapped();
  const auto branch = entry.branch;
  const auto reason = "a call did not return within " +
                      std::to_string(deadline_of(entry).count()) + " ms";
  entry.instance->watch.give_up();
  branch->component->mailbox->leave(entry.host);
  close(entry, reason);
  if (const auto kept = is_coming(branch))
    came_not(kept, {ErrorKind::timeout, reason, {}});
  else if (is_kept(branch) && entry.stage != Stage::stops)
    count_failure(branch, reason);
  else
    parts_.observer.log(branch->name() + " does not stop: " + reason);
  after_end(branch);
}

} // namespace parlour::actors
