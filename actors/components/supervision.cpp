#include "actors/components/supervision.hpp"

#include <algorithm>
#include <utility>

#include "runtime/base/call_deadline.hpp"

namespace parlour::actors {

namespace {

std::string_view words_for(ServiceState state) {
  return state == ServiceState::backing_off ? "backing off" : name_of(state);
}

void keep(component_promise promise, Expected<void> outcome) {
  promise.deliver(component_done{std::move(outcome)});
}

} // namespace

Supervision::Supervision(supervisor_actor::pointer self, SupervisionParts parts)
    : parts_(std::move(parts)), news_(parts_),
      running_(self, parts_, news_, deployments_),
      rules_(parts_.settings, deployments_),
      placements_(parts_, deployments_, news_, running_),
      departures_(self, running_, news_) {}

// -- what is asked for --------------------------------------------------------

// One without instances is for <load> alone.
void Supervision::load(const load_component& what, component_promise promise) {
  if (auto may = may_load(*what.order); !may)
    return keep(std::move(promise), may);
  rules_.remember(*what.order);
  if (what.order->policy.scope.instances == 0)
    return keep(std::move(promise), {});
  load(*what.order, what.rank, false, std::move(promise));
}

// A script's `<load>`: its rank is that of the one it replaces, else the last,
// and everybody hears that it is up.
void Supervision::load(const load_plugin& what, component_promise promise) {
  auto order = rules_.order_for(what.plugin, what.name);
  if (!order)
    return keep(std::move(promise), tl::make_unexpected(order.error()));
  if (auto may = may_load(*order); !may)
    return keep(std::move(promise), may);
  load(*order, 0, true, std::move(promise));
}

// Out of the table first: nobody finds it while it finishes what it has begun.
void Supervision::unload(const unload_component& what,
                         component_promise promise) {
  const auto found = deployments_.serving.extract(what.name);
  if (!found)
    return keep(std::move(promise),
                tl::make_unexpected(rules_.nobody_called(what.name)));
  news_.publish_table(deployments_.by_rank());
  departures_.depart(found.mapped()->all(), what.name, std::move(promise));
  take_reports();
}

// No mailbox is handed on and no failure is answered any more: sessions have
// ended by now, and whoever still asks is ending, too. The mailboxes are
// emptied last, as their messages hold tokens that keep the node busy.
void Supervision::stop_all() {
  closing_ = true;
  running_.close();
  news_.stop_answering();
  std::vector<ServicePointer> serving;
  for (const auto& deployment : deployments_.all())
    for (const auto& service : deployment->all()) {
      running_.happens(service, ServiceEvent::leave);
      if (deployments_.is_serving(deployment))
        serving.push_back(service);
    }
  for (const auto& service : serving)
    service->component->mailbox->close("stops");
  running_.stop_all();
  for (const auto& service : serving)
    service->component->mailbox->take_all();
  take_reports();
}

// -- coming -------------------------------------------------------------------

Expected<void> Supervision::may_load(const ComponentOrder& order) const {
  if (closing_)
    return fail(ErrorKind::cancelled, "the application stops");
  if (const auto& seat = order.policy.seat;
      !seat.empty() && !placements_.has_seat(seat))
    return fail(ErrorKind::settings,
                order.name + ": there is no seat '" + seat +
                    "' in this run; seats are those with which it was started");
  return rules_.check(order);
}

void Supervision::load(const ComponentOrder& order, std::size_t rank, bool tell,
                       component_promise promise) {
  using enum Scope::Kind;
  auto deployment = std::make_shared<Deployment>();
  deployment->order = order;
  auto& policy = deployment->order.policy;
  policy.deadline = call_deadline(policy, parts_.settings.request_timeout);
  deployment->rank = rank;
  deployment->tell = tell;
  deployment->promise = std::move(promise);
  if (const auto scope = policy.scope.kind; scope == seat || scope == session)
    deployment->by_session = std::make_shared<InstanceList>();
  deployments_.coming[order.name] = deployment;
  placements_.settle(deployment);
  check_activation(deployment); // nobody may be there yet to have an instance
}

// One of its instances works, or is not wanted any more: once all that are
// left work, it takes over. Held by value, as it leaves those that come.
void Supervision::check_activation(DeploymentPointer deployment) {
  if (!all_work(*deployment))
    return;
  deployments_.coming.erase(deployment->name());
  take_over(deployment);
  placements_.settle(deployment); // who came meanwhile
  if (deployment->tell)
    for (const auto& service : deployment->all())
      news_.tell_up(*service);
  keep(std::exchange(deployment->promise, {}), {});
}

// True, too, where there is no instance at all: a component for each session,
// while no session is there.
bool Supervision::all_work(const Deployment& deployment) const {
  for (const auto& service : deployment.all())
    for (auto id : service->instances)
      if (running_.state_of(id) != InstanceState::working)
        return false;
  return true;
}

// The order matters: the new services accept messages before the table leads to
// them, and have the mailboxes before the old ones depart.
void Supervision::take_over(const DeploymentPointer& deployment) {
  const auto before = replace(deployment);
  for (const auto& service : deployment->all())
    running_.happens(service, ServiceEvent::takes_over);
  news_.publish_table(deployments_.by_rank());
  take_mailboxes(*deployment, before.get());
  if (before)
    departures_.depart(before->all(), {}, {});
}

// Returns the one whose rank it takes; null where its name is new.
DeploymentPointer Supervision::replace(const DeploymentPointer& deployment) {
  auto& current = deployments_.serving[deployment->name()];
  if (current)
    deployment->rank = current->rank;
  else if (deployment->rank == 0)
    deployment->rank = last_rank_ + 1;
  last_rank_ = std::max(last_rank_, deployment->rank);
  return std::exchange(current, deployment);
}

// Where an instance of the one before still finishes what it has, the new one
// begins after it.
// The mailbox itself is the same object for both (Placements::mailbox_at): what
// is handed on is the right to take from it.
void Supervision::take_mailboxes(const Deployment& deployment,
                                 const Deployment* before) {
  for (const auto& [scope, service] : deployment.services) {
    service->component->mailbox->open();
    const auto old =
        before ? before->services.find(scope) : deployment.services.end();
    if (!before || old == before->services.end()) {
      running_.begin(service->instances);
      continue;
    }
    old->second->handed_on = true;
    old->second->successors = service->instances;
  }
}

// What was there before stays.
void Supervision::activation_failed(const ServicePointer& service,
                                    const Error& error) {
  const auto deployment = deployments_.coming.extract(service->name()).mapped();
  for (const auto& one : deployment->all()) {
    running_.happens(one, ServiceEvent::leave);
    running_.happens_to_all(*one, InstanceEvent::stop);
  }
  keep(std::exchange(deployment->promise, {}), tl::make_unexpected(error));
}

// -- what happens -------------------------------------------------------------

void Supervision::started(const instance_started& what) {
  if (what.outcome)
    running_.happens(what.instance, InstanceEvent::started);
  else
    running_.happens(what.instance, InstanceEvent::not_started,
                     {what.outcome.error()});
  take_reports();
}

void Supervision::stopped(const instance_stopped& what) {
  running_.happens(what.instance, InstanceEvent::stopped,
                   {{ErrorKind::offline, "it was stopped", {}}});
  take_reports();
}

void Supervision::failed(const component_failed& what) {
  if (what.instance == 0)
    failed_inline(what);
  else
    running_.happens(what.instance, InstanceEvent::failed,
                     {{ErrorKind::settings, what.reason, {}}});
  take_reports();
}

// It was called in a session's own turn, and has one service: the node's.
void Supervision::failed_inline(const component_failed& what) {
  const auto deployment = deployments_.find(what.name);
  if (!deployment || deployment->by_session || closing_)
    return;
  running_.happens(deployment->services.begin()->second, ServiceEvent::failed,
                   {{ErrorKind::settings, what.reason, {}}});
}

// No transition of any table: it concerns the routing alone. One that leaves
// may owe nothing any more, now that it has been answered for.
void Supervision::available(const component_available& what) {
  running_.available(what.instance, what.is_available);
  departures_.idle(what.instance);
  take_reports();
}

void Supervision::watch(const watch_instance& what) {
  running_.watch(what);
  take_reports();
}

void Supervision::idle(const instance_idle& what) {
  departures_.idle(what.instance);
  take_reports();
}

// Whoever has read nothing yet will read the new one.
environment_changed Supervision::change(const change_environment& what) {
  parts_.environment.change(what.environment);
  environment_changed changed;
  for (const auto& [name, deployment] : deployments_.serving)
    if (std::ranges::any_of(deployment->all(), [this](const auto& service) {
          return running_.has_read_language(*service);
        }))
      changed.readers[name] = deployment->order.factory.description.name;
  return changed;
}

// The component may have been unloaded or replaced during the pause, or its
// session may be over.
void Supervision::try_again(const actors::try_again& what) {
  const auto deployment = deployments_.find(what.name);
  if (!deployment)
    return;
  const auto found = deployment->services.find(what.scope);
  if (found == deployment->services.end() || found->second->trial != what.trial)
    return;
  found->second->due = {};
  running_.happens(found->second, ServiceEvent::retry);
  take_reports();
}

void Supervision::drain_over(const actors::drain_over& what) {
  departures_.drain_over(what);
  take_reports();
}

void Supervision::take_reports() {
  while (const auto report = running_.take_report())
    take(*report);
}

void Supervision::take(const ServiceReport& report) {
  switch (report.what) {
  case ServiceReport::What::instance_started:
    return check_activation(deployments_.coming.at(report.service->name()));
  case ServiceReport::What::activation_failed:
    return activation_failed(report.service, report.error);
  case ServiceReport::What::instance_ended:
    return departures_.instance_ended(report.service);
  }
}

// What serves and is well is only counted.
std::string Supervision::doing() const {
  auto text = std::to_string(deployments_.serving.size()) + " components";
  if (!deployments_.coming.empty())
    text += ", " + std::to_string(deployments_.coming.size()) + " coming";
  for (const auto& [name, deployment] : deployments_.serving)
    for (const auto& service : deployment->all())
      if (service->state != ServiceState::serving)
        text += "; " + name + " is " + std::string(words_for(service->state));
  return text;
}

// -- seats and sessions -------------------------------------------------------

void Supervision::opened(const seat_opened& what) {
  placements_.seat_opened(what);
}

// The seat's own instances depart; its session has ended before.
void Supervision::closed(const seat_closed& what) {
  placements_.seat_closed(what);
  for (const auto& deployment : deployments_.all())
    dismiss(deployment, what.name);
  take_reports();
}

void Supervision::begins(const session_begins& what) {
  placements_.session_begins(what.session);
}

// What its own instances were given before it ended they still do.
void Supervision::ended(const session_ended& what) {
  placements_.session_ended(what);
  for (const auto& deployment : deployments_.all())
    dismiss(deployment, what.session);
  take_reports();
}

void Supervision::dismiss(const DeploymentPointer& deployment,
                          const std::string& scope) {
  auto service = placements_.detach(*deployment, scope);
  if (!service)
    return;
  departures_.depart({std::move(service)}, {}, {});
  if (deployments_.is_coming(deployment))
    check_activation(deployment);
}

} // namespace parlour::actors
