#include "actors/components/placements.hpp"

#include <algorithm>
#include <utility>

namespace parlour::actors {

namespace {

bool is_per_seat(const Deployment& deployment) {
  return deployment.order.policy.scope.kind == Scope::Kind::seat;
}

// Whether it has an instance at this seat.
bool is_for(const Deployment& deployment, const std::string& seat) {
  const auto& bound_to = deployment.order.policy.seat;
  return is_per_seat(deployment) && (bound_to.empty() || bound_to == seat);
}

} // namespace

// -- who is there -------------------------------------------------------------

void Placements::seat_opened(const actors::seat_opened& what) {
  auto& seat = seats_[what.seat] = {what.name};
  for (const auto& deployment : deployments_.all())
    if (is_for(*deployment, seat.name))
      attach_seat(deployment, seat);
}

bool Placements::has_seat(const std::string& name) const {
  return std::ranges::any_of(
      seats_, [&](const auto& seat) { return seat.second.name == name; });
}

void Placements::seat_closed(const actors::seat_closed& what) {
  seats_.erase(what.seat);
}

// All deployments, also those that are coming: a component that is just being
// replaced has to have an instance for this session in either case.
void Placements::session_begins(const SessionId& session) {
  const auto seat = parts_.sessions.seat_of(session);
  for (const auto& deployment : deployments_.all())
    attach(deployment, session, seat);
}

// The seat's instances stay, and speak for the seat until its next session.
void Placements::session_ended(const actors::session_ended& what) {
  const auto seat = seats_.find(what.seat);
  if (seat != seats_.end() && seat->second.scope)
    seat->second.scope->is_over(what.session);
}

void Placements::settle(const DeploymentPointer& deployment) {
  if (!deployment->by_session) {
    service_for(deployment, node_);
    return;
  }
  for (auto& [actor, seat] : seats_)
    if (is_for(*deployment, seat.name))
      attach_seat(deployment, seat);
  for (const auto& [id, session, seat] : parts_.sessions.all())
    attach(deployment, id, seat);
}

// Until a session begins there, it speaks for the seat itself.
const std::shared_ptr<InstanceScope>& Placements::scope_of(Seat& seat) {
  if (!seat.scope)
    seat.scope = std::make_shared<InstanceScope>(seat.name, seat.name);
  return seat.scope;
}

// Components of a seat hear each other also between two sessions: their
// messages belong to the seat's name then.
void Placements::attach_seat(const DeploymentPointer& deployment, Seat& seat) {
  if (const auto service = service_for(deployment, scope_of(seat)))
    deployment->by_session->put(
        seat.name, {service->component->mailbox, service->component->up});
}

// A seat's instance stays the same from session to session; only whom it speaks
// for changes.
void Placements::attach(const DeploymentPointer& deployment,
                        const SessionId& session, const seat_actor& seat) {
  if (!deployment->by_session)
    return;
  auto scope = std::make_shared<InstanceScope>(session, session);
  if (is_per_seat(*deployment)) {
    const auto found = seats_.find(seat);
    if (found == seats_.end() || !is_for(*deployment, found->second.name))
      return;
    scope = scope_of(found->second);
    scope->begins(session);
  }
  if (const auto service = service_for(deployment, scope))
    deployment->by_session->put(
        session, {service->component->mailbox, service->component->up});
}

// A seat's stays for the seat's next session.
ServicePointer Placements::detach(Deployment& deployment,
                                  const std::string& scope) const {
  if (!deployment.by_session)
    return nullptr;
  deployment.by_session->remove(scope);
  auto service = deployment.services.extract(scope);
  if (!service)
    return nullptr;
  service.mapped()->over = true;
  return std::move(service.mapped());
}

// -- what it has --------------------------------------------------------------

// The one that the scope has, or a new one; null where there may be no more.
ServicePointer
Placements::service_for(const DeploymentPointer& deployment,
                        const std::shared_ptr<InstanceScope>& scope) {
  const auto found = deployment->services.find(scope->name());
  if (found != deployment->services.end())
    return found->second;
  if (deployment->services.size() < max_services)
    return add_service(deployment, scope);
  refuse(*deployment, *scope);
  return nullptr;
}

void Placements::refuse(const Deployment& deployment,
                        const InstanceScope& scope) const {
  const auto reason = "has " + std::to_string(max_services) +
                      " instances, as many as it may have";
  news_.log(deployment.name() + " " + reason);
  news_.tell("ComponentDown", {deployment.name(), reason}, scope.session());
}

// The one that another of its name, which it replaces or is replaced by, has in
// this scope already: nothing that waits there is lost.
std::shared_ptr<ComponentMailbox>
Placements::mailbox_at(const std::string& name,
                       const InstanceScope& scope) const {
  for (const auto& deployment : deployments_.all())
    if (deployment->name() == name)
      if (const auto found = deployment->services.find(scope.name());
          found != deployment->services.end())
        return found->second->component->mailbox;
  return std::make_shared<ComponentMailbox>();
}

// Until its instance works, its messages wait.
ServicePointer
Placements::add_service(const DeploymentPointer& deployment,
                        const std::shared_ptr<InstanceScope>& scope) {
  const bool serves = deployments_.is_serving(deployment);
  auto service = std::make_shared<Service>();
  service->scope = scope;
  service->state = serves ? ServiceState::serving : ServiceState::coming;
  service->component = std::make_shared<Component>();
  service->component->order = deployment->order;
  service->component->mailbox = mailbox_at(deployment->name(), *scope);
  service->component->set_serving(serves);
  deployment->services[scope->name()] = service;
  running_.fill_up(service);
  return service;
}

} // namespace parlour::actors
