#include "actors/components/running_instances.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/components/instance/component_host.hpp"

namespace parlour::actors {

namespace {

// A plug-in that may block would hold up the session that calls it; one with a
// scope of its own was given a mailbox by the settings.
bool is_called_inline(const Component& component) {
  using enum Scope::Kind;
  const auto scope = component.order.policy.scope.kind;
  return component.description().is_inline && !component.description().blocks &&
         (scope == usual || scope == in_turn);
}

// Keeps its whole instance.
// The pointer shares the ownership of the instance: a session that still calls
// keeps plug-in and context alive.
std::shared_ptr<const InlinePlugin>
direct_of(const std::shared_ptr<Instance>& instance) {
  const auto* plugin =
      dynamic_cast<const InlinePlugin*>(instance->plugin.get());
  if (!plugin || !is_called_inline(*instance->component))
    return nullptr;
  return {instance, plugin};
}

} // namespace

// -- events -------------------------------------------------------------------

void RunningInstances::happens(const ServicePointer& service,
                               ServiceEvent event, const Cause& cause) {
  events_.happens(service, event, cause);
  take_events();
}

void RunningInstances::happens(InstanceId id, InstanceEvent event,
                               const Cause& cause) {
  events_.happens(id, event, cause);
  take_events();
}

// Called from inside of a deed it returns at once: the loop that runs that deed
// takes the new event next.
void RunningInstances::take_events() {
  if (std::exchange(takes_events_, true))
    return;
  while (const auto transition = events_.next())
    std::visit([this](const auto& one) { carry_out(one); }, *transition);
  takes_events_ = false;
}

void RunningInstances::carry_out(const InstanceDeeds& deeds) {
  for (auto deed : deeds.deeds)
    carry_out(deed, deeds.id, deeds.cause);
}

void RunningInstances::carry_out(const ServiceDeeds& deeds) {
  for (auto deed : deeds.deeds)
    carry_out(deed, deeds.service, deeds.cause);
}

void RunningInstances::carry_out(const Impossible& what) {
  news_.log("error: " + what.text);
  assert(false && "the table of its life says that this cannot happen");
}

std::optional<ServiceReport> RunningInstances::take_report() {
  if (reports_.empty())
    return std::nullopt;
  auto report = std::move(reports_.front());
  reports_.pop_front();
  return report;
}

// -- services -----------------------------------------------------------------

// What concerns the whole component is only noted here, as a report: the caller
// is in the middle of its own maps.
void RunningInstances::carry_out(ServiceDeed deed,
                                 const ServicePointer& service,
                                 const Cause& cause) {
  using What = ServiceReport::What;
  switch (deed) {
  case ServiceDeed::report_start:
    reports_.push_back({What::instance_started, service, {}});
    return;
  case ServiceDeed::fail_activation:
    reports_.push_back({What::activation_failed, service, cause.error});
    return;
  case ServiceDeed::come_up:
    service->component->set_serving(true);
    return;
  case ServiceDeed::add_worker:
    return add_worker(*service, entries_.at(cause.instance));
  case ServiceDeed::fill_up:
    return fill_up(service);
  case ServiceDeed::count_failure:
    return count_failure(service, cause);
  case ServiceDeed::retry_later:
    service->due = ticket(cause.pause);
    return try_later(*service, cause.pause);
  case ServiceDeed::take_down:
    return take_down(*service, cause);
  case ServiceDeed::log_failure:
    return news_.log(service->name() +
                     " failed while it left: " + cause.error.message);
  case ServiceDeed::report_end:
    reports_.push_back({What::instance_ended, service, {}});
    return;
  }
}

// In the place of one that failed, or as the first of its session or seat. What
// is called without a mailbox is another object now: that is published before
// messages are routed to it.
void RunningInstances::add_worker(const Service& service, const Entry& entry) {
  auto& component = *service.component;
  if (service.direct)
    news_.publish_table(deployments_.by_rank());
  component.mailbox->open();
  component.mailbox->add_worker(entry.host);
  component.set_serving(true);
  if (service.failures.count() == 0)
    return;
  parts_.observer.metrics().component(service.name()).restarts.add();
  news_.tell_up(service);
}

// The scripts hear of the failure before they hear that the component is down.
// All instances of a pool go down together, as they run the same code with the
// same options.
void RunningInstances::count_failure(const ServicePointer& service,
                                     const Cause& cause) {
  const auto verdict = service->failures.failed(parts_.time.now());
  const auto& reason = cause.error.message;
  service->last_error = reason;
  parts_.observer.metrics().component(service->name()).failures.add();
  last_error_ = service->name() + " failed: " + reason;
  news_.log(last_error_);
  news_.tell("ComponentFailed",
             {service->name(), reason, service->failures.count()},
             service->scope->session());
  if (verdict.down)
    happens_to_all(*service, InstanceEvent::go_down, cause);
  happens(service,
          verdict.down ? ServiceEvent::exhausted : ServiceEvent::to_retry,
          {cause.error, verdict.pause});
}

// First nobody routes to it any more, then the mailbox refuses, then what is in
// it is answered: a message that comes in between is refused with a reason.
void RunningInstances::take_down(Service& service, const Cause& cause) {
  const auto& reason = cause.error.message;
  service.component->set_serving(false);
  service.component->mailbox->close("is down");
  news_.log(service.name() + " is down");
  news_.answer_what_waits(service, reason);
  news_.tell("ComponentDown", {service.name(), reason},
             service.scope->session());
  service.due = {}; // what waits for its return is not to be waited for
  try_later(service, cause.pause);
}

// An outdated trial is recognised by its number: another failure may have set
// another pause meanwhile.
void RunningInstances::try_later(Service& service, Milliseconds pause) {
  service.trial = ++last_trial_;
  const try_again again{service.name(), service.scope->name(), service.trial};
  if (pause > Milliseconds::zero())
    self_->delayed_send(self_, pause, again);
  else
    self_->send(self_, again);
}

// A pool that lost one of three instances gets one; a new service gets all.
void RunningInstances::fill_up(const ServicePointer& service) {
  const auto& ids = service->instances;
  const bool one_stops = std::ranges::any_of(
      ids, [&](auto id) { return state_of(id) == InstanceState::stopping; });
  if (one_stops || closed_)
    return;
  const auto wanted = service->component->order.policy.scope.instances;
  for (auto i = ids.size(); i < wanted; ++i)
    make_instance(service);
}

// -- making -------------------------------------------------------------------

// The directory knows the instance before its plug-in exists, and the watchdog
// holds a token for the start: the node is not quiet while it starts.
void RunningInstances::make_instance(const ServicePointer& service) {
  const auto& component = service->component;
  const bool is_nodes = service->scope->name().empty();
  auto instance = std::make_shared<Instance>();
  instance->id = ++last_instance_;
  instance->component = component;
  component->set_available(true); // until it says otherwise
  instance->last_error = service->last_error;
  instance->context = std::make_shared<ComponentContext>(
      ContextParts{parts_.time, parts_.bus, parts_.observer, parts_.environment,
                   supervisor_actor(self_)},
      component->name(), component->description(), instance->id,
      is_nodes ? nullptr : service->scope);
  auto host = host_for(instance);
  parts_.instances.add(component->name(), {instance, &instance->watch}, host);
  instance->context->belongs_to(host);
  instance->watch.expect(parts_.time.work.begin());
  self_->send(host, start_component{});
  const auto id = instance->id;
  events_.begin(id);
  service->instances.push_back(id);
  entries_[id] = {std::move(instance), std::move(host), service,
                  std::max(component->deadline(), parts_.settings.start_time)};
}

// In real time each has a thread of its own: one that hangs takes no other's.
component_host_actor
RunningInstances::host_for(const std::shared_ptr<Instance>& instance) {
  auto& system = self_->home_system();
  HostParts parts{&parts_.time, &parts_.observer, supervisor_actor(self_),
                  parts_.settings.detaches};
  return parts.has_thread
             ? system.spawn<caf::detached>(component_host, std::move(parts),
                                           instance)
             : system.spawn(component_host, std::move(parts), instance);
}

// -- instances ----------------------------------------------------------------

bool RunningInstances::has_read_language(const Service& service) const {
  return std::ranges::any_of(service.instances, [this](auto id) {
    return entries_.at(id).instance->context->has_read_language();
  });
}

// A remote agent that goes away is no failure: the plug-in that stands for it
// stays. What it was asked and what waits in its mailbox is answered at once;
// what waits where one leaves is left to whoever has that mailbox then.
void RunningInstances::available(InstanceId id, bool is_available) {
  const auto found = entries_.find(id);
  if (found == entries_.end())
    return;
  auto& service = *found->second.service;
  const bool before = *service.component->up;
  service.component->set_available(is_available);
  if (*service.component->up == before)
    return;
  if (is_available)
    return news_.tell_available(service, true);
  auto unanswered = found->second.instance->context->take_pending();
  if (service.state != ServiceState::leaving)
    for (auto& job : service.component->mailbox->take_all())
      unanswered.push_back(*job.message);
  news_.tell_available(service, false, std::move(unanswered));
}

void RunningInstances::happens_to_all(const Service& service,
                                      InstanceEvent event, const Cause& cause) {
  const auto ids = service.instances; // some may end
  for (auto id : ids)
    happens(id, event, cause);
}

void RunningInstances::stop_all() {
  std::vector<InstanceId> ids;
  for (const auto& [id, entry] : entries_)
    ids.push_back(id);
  for (auto id : ids)
    happens(id, InstanceEvent::stop);
}

// `remove` is the last of its deeds: the entry is gone with it.
void RunningInstances::carry_out(InstanceDeed deed, InstanceId id,
                                 const Cause& cause) {
  auto& entry = entries_.at(id);
  switch (deed) {
  case InstanceDeed::watch_calls:
    entry.deadline = entry.service->component->deadline();
    return entry.instance->watch.watch_anew();
  case InstanceDeed::enlist:
    return enlist(entry);
  case InstanceDeed::begin_draining:
    return begin_draining(entry);
  case InstanceDeed::stop_plugin:
    entry.deadline = entry.service->component->deadline();
    return stop_plugin(entry);
  case InstanceDeed::abandon:
    return abandon(entry);
  case InstanceDeed::answer_failure:
    return answer_failure(entry, cause.error.message);
  case InstanceDeed::blame:
    return happens(entry.service, ServiceEvent::failed, cause);
  case InstanceDeed::complain:
    return news_.log(entry.service->name() +
                     " does not stop: " + cause.error.message);
  case InstanceDeed::remove:
    return remove(id);
  }
}

// Whether its service serves already or is still coming says the other table.
void RunningInstances::enlist(const Entry& entry) {
  entry.service->direct = direct_of(entry.instance);
  Cause cause;
  cause.instance = entry.instance->id;
  happens(entry.service, ServiceEvent::worker_started, cause);
}

// One whose mailbox a successor has takes nothing more from it; an unloaded one
// empties its mailbox first.
void RunningInstances::begin_draining(const Entry& entry) {
  if (entry.service->handed_on)
    entry.service->component->mailbox->remove_worker(entry.host);
  entry.instance->draining = true;
  entry.instance->context->drain();
}

// Messages that it took no more of stay in the mailbox for others.
void RunningInstances::stop_plugin(const Entry& entry) {
  entry.service->component->mailbox->remove_worker(entry.host);
  entry.instance->watch.expect(parts_.time.work.begin());
  self_->send(entry.host, stop_component{});
}

// Its actor and its thread are left to themselves.
void RunningInstances::abandon(const Entry& entry) {
  entry.instance->watch.give_up();
  entry.service->component->mailbox->remove_worker(entry.host);
}

void RunningInstances::answer_failure(const Entry& entry,
                                      const std::string& reason) {
  news_.answer_by_failure(*entry.service, entry.instance->context->close(),
                          reason);
}

void RunningInstances::remove(InstanceId id) {
  const auto entry = entries_.extract(id);
  std::erase(entry.mapped().service->instances, id);
  happens(entry.mapped().service, ServiceEvent::instance_gone);
}

ServicePointer RunningInstances::service_of(InstanceId id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : found->second.service;
}

// Where a successor has the mailbox, what waits there is no longer its own.
bool RunningInstances::has_finished(InstanceId id) const {
  const auto& [instance, host, service, deadline] = entries_.at(id);
  return !instance->watch.in_call() && instance->context->owes_nothing() &&
         (service->handed_on || service->component->mailbox->empty());
}

void RunningInstances::begin(const std::vector<InstanceId>& instances) {
  for (auto id : instances)
    if (state_of(id) == InstanceState::working) {
      const auto& entry = entries_.at(id);
      entry.service->component->mailbox->add_worker(entry.host);
    }
}

// -- time ---------------------------------------------------------------------

void RunningInstances::watch(const watch_instance& what) {
  const auto found = entries_.find(what.instance);
  if (found == entries_.end())
    return;
  const auto deadline = found->second.deadline;
  std::optional left = deadline;
  if (!what.begins)
    left = found->second.instance->watch.time_left(parts_.time.now(), deadline);
  if (left && *left <= Milliseconds::zero())
    happens(what.instance, InstanceEvent::hung,
            {{ErrorKind::timeout,
              "a call did not return within " +
                  std::to_string(deadline.count()) + " ms",
              {}}});
  else if (left)
    self_->delayed_send(self_, *left, watch_instance{what.instance, false});
}

DueTicket RunningInstances::ticket(Milliseconds delay) const {
  const auto due = parts_.time.now() + delay.count();
  return {parts_.time.due_times,
          parts_.time.due_times.add(due, DueTimes::Of::component)};
}

} // namespace parlour::actors
