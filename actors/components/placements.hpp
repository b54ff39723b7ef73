// Placements: which seat and which session has what of each component, where
// it is not one for the whole node. Lives on the supervisor's thread.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "actors/components/running_instances.hpp"

namespace parlour::actors {

// A component with scope="session" has an instance for each session, one with
// scope="seat" for each seat. They come with the seat or session, or with the
// component if that is loaded later (settle), and go with the first of them.
// One that is bound to a configured seat has an instance there alone.
class Placements {
public:
  // A component has instances for no more scopes: each costs a thread.
  static constexpr std::size_t max_services = 1'000;

  Placements(const SupervisionParts& parts, const Deployments& deployments,
             const ComponentNews& news, RunningInstances& running)
      : parts_(parts), deployments_(deployments), news_(news),
        running_(running) {}

  void seat_opened(const actors::seat_opened& what);
  void seat_closed(const actors::seat_closed& what);
  void session_begins(const SessionId& session);
  void session_ended(const session_ended& what);

  // Whether a component may be bound to it.
  bool has_seat(const std::string& name) const;

  // Every scope gets what it is to have of this component.
  void settle(const DeploymentPointer& deployment);
  // What the session or the seat of that name had of it, and has no more; null
  // where it had none of its own.
  ServicePointer detach(Deployment& deployment, const std::string& scope) const;

private:
  struct Seat {
    std::string name;
    // Made for the first component that has an instance there.
    std::shared_ptr<InstanceScope> scope = nullptr;
  };

  static const std::shared_ptr<InstanceScope>& scope_of(Seat& seat);
  void attach_seat(const DeploymentPointer& deployment, Seat& seat);
  // Lets the session's messages find the instance of the session, or of its
  // seat.
  void attach(const DeploymentPointer& deployment, const SessionId& session,
              const seat_actor& seat);
  ServicePointer service_for(const DeploymentPointer& deployment,
                             const std::shared_ptr<InstanceScope>& scope);
  // Nobody waits for the instance: the log and System.ComponentDown tell that
  // it is missing.
  void refuse(const Deployment& deployment, const InstanceScope& scope) const;
  std::shared_ptr<ComponentMailbox>
  mailbox_at(const std::string& name, const InstanceScope& scope) const;
  ServicePointer add_service(const DeploymentPointer& deployment,
                             const std::shared_ptr<InstanceScope>& scope);

  const SupervisionParts& parts_;
  const Deployments& deployments_;
  const ComponentNews& news_;
  RunningInstances& running_;
  // The scope without a name.
  const std::shared_ptr<InstanceScope> node_ =
      std::make_shared<InstanceScope>();
  std::map<seat_actor, Seat> seats_;
};

} // namespace parlour::actors
