// Deployment: a component as it was loaded, and what each scope has of it.
// Service: one of these: a mailbox, its instances, their failures. Data
// only; lives on the supervisor's thread.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "actors/components/instance/component.hpp"
#include "actors/components/service_life.hpp"
#include "actors/routing/instance_list.hpp"
#include "actors/support/instance_scope.hpp"
#include "actors/support/restart_policy.hpp"

namespace parlour::actors {

// It outlives its instances: while one that failed is replaced, the messages
// wait in its mailbox, and the failures are counted here. `state` is what
// service_life.def says; RunningInstances alone changes it.
struct Service {
  std::shared_ptr<Component> component;
  std::shared_ptr<InstanceScope> scope;
  ServiceState state = ServiceState::coming;
  RestartPolicy failures;
  std::string last_error = {}; // of those
  // Callable in a session's own turn; null: only by its mailbox.
  std::shared_ptr<const InlinePlugin> direct = nullptr;
  bool handed_on = false;  // its mailbox is a successor's by now
  bool over = false;       // its scope is: nobody waits for its answers
  std::uint64_t trial = 0; // the try_again that counts; others are outdated
  DueTicket due = {};      // of that
  std::vector<InstanceId> instances = {}; // that run, oldest first
  // They take over the mailbox when it has finished: else what was said last
  // might be answered first.
  std::vector<InstanceId> successors = {};

  const std::string& name() const {
    return component->name();
  }
};
using ServicePointer = std::shared_ptr<Service>;

// While a component is replaced there are two of one name: the one that serves,
// and the one that is coming. A scope is named by its seat or session; the
// node's has the empty name.
struct Deployment {
  ComponentOrder order;
  std::size_t rank = 0; // among the components of its roles
  std::map<std::string, ServicePointer> services; // by scope
  // Those of the sessions, for the table; null: it has the node's only.
  std::shared_ptr<InstanceList> by_session = nullptr;
  bool tell = false;              // everybody of its coming
  component_promise promise = {}; // kept once it serves, or has failed to

  const std::string& name() const {
    return order.name;
  }
  std::vector<ServicePointer> all() const;
};
using DeploymentPointer = std::shared_ptr<Deployment>;

// A node's deployments, by name.
// A name is at most once in each map. What departs is in neither
// (departures.hpp).
struct Deployments {
  std::map<std::string, DeploymentPointer> serving;
  std::map<std::string, DeploymentPointer> coming; // not all have started

  // Null where there is none of that name.
  DeploymentPointer find(const std::string& name) const;
  bool is_coming(const DeploymentPointer& deployment) const;
  bool is_serving(const DeploymentPointer& deployment) const;
  std::vector<DeploymentPointer> all() const; // those that serve first
  // Those that serve, in the order of preference.
  std::vector<DeploymentPointer> by_rank() const;
};

} // namespace parlour::actors
