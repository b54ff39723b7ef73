// Supervision: the components of a node: loaded, replaced, unloaded, tried
// again after a failure (engine rule 7.3). The supervisor's state; lives on its
// thread. A component comes (its instances start), serves, and departs (its
// instances finish what they have, then stop).
//
// Here is how components come and go as a whole. What follows from what happens
// to one instance stands in two tables, which RunningInstances carries out;
// which scopes have instances is Placements' to say, and what still has time to
// finish is a Departure.
#pragma once

#include <string>
#include <vector>

#include "actors/components/departures.hpp"
#include "actors/components/loading_rules.hpp"
#include "actors/components/placements.hpp"

namespace parlour::actors {

// Every function does its part and then takes the reports of RunningInstances:
// these say what has become of whole components, and may lead to more.
class Supervision {
public:
  // `self` is the actor whose state this is.
  Supervision(supervisor_actor::pointer self, SupervisionParts parts);
  Supervision(const Supervision&) = delete;
  Supervision& operator=(const Supervision&) = delete;

  // -- what is asked for; the promise is kept when it is done ----------------
  void load(const load_component& what, component_promise promise);
  void load(const load_plugin& what, component_promise promise);
  void unload(const unload_component& what, component_promise promise);
  void stop_all();

  // -- what happens ----------------------------------------------------------
  void started(const instance_started& what);
  void stopped(const instance_stopped& what);
  void failed(const component_failed& what);
  void available(const component_available& what);
  void watch(const watch_instance& what);
  void idle(const instance_idle& what);
  void try_again(const actors::try_again& what);
  void drain_over(const actors::drain_over& what);
  void opened(const seat_opened& what);
  void closed(const seat_closed& what);
  void begins(const session_begins& what);
  void ended(const session_ended& what);
  // Returned are those to be loaded again: they have read the one before.
  environment_changed change(const change_environment& what);

  // -- for who asks how it is "3 components, 1 coming; City is down".
  std::string doing() const;
  // Of all components.
  const std::string& last_error() const {
    return running_.last_error();
  }

private:
  // What became of services in what was just done.
  void take_reports();
  void take(const ServiceReport& report);
  void activation_failed(const ServicePointer& service, const Error& error);

  Expected<void> may_load(const ComponentOrder& order) const;
  void load(const ComponentOrder& order, std::size_t rank, bool tell,
            component_promise promise);
  void check_activation(DeploymentPointer deployment);
  bool all_work(const Deployment& deployment) const;
  // From the deployment's coming to its serving: the routes lead to it, and the
  // one before departs.
  void take_over(const DeploymentPointer& deployment);
  DeploymentPointer replace(const DeploymentPointer& deployment);
  void take_mailboxes(const Deployment& deployment, const Deployment* before);
  void failed_inline(const component_failed& what);
  // What the scope has of it is no longer wanted.
  void dismiss(const DeploymentPointer& deployment, const std::string& scope);

  const SupervisionParts parts_;
  ComponentNews news_;
  Deployments deployments_;
  RunningInstances running_;
  LoadingRules rules_;
  Placements placements_;
  Departures departures_;
  // The highest that was given; a component of a new name comes behind it.
  std::size_t last_rank_ = 0;
  bool closing_ = false;
};

} // namespace parlour::actors
