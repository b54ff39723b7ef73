// Departures: components that were replaced or unloaded, and the instances of
// sessions that are over. Each departure has some time to finish what it has
// begun; then its instances are stopped. Lives on the supervisor's thread.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "actors/components/running_instances.hpp"

namespace parlour::actors {

// A replaced component hands its mailbox on: its successors begin as soon as
// its own instances have all stopped taking messages, so that what was said
// first is answered first. An unloaded one has nobody to hand on to: what waits
// then is answered by a failure.
class Departures {
public:
  // For what a departing instance has begun.
  // A longer one would delay the successor, and `<unload>`, by as much; a
  // shorter one cuts off more answers. Waits of scripts count on it (engine
  // rule 2.4).
  static constexpr Milliseconds drain_time{2'000};

  Departures(supervisor_actor::pointer self, RunningInstances& running,
             const ComponentNews& news)
      : self_(self), running_(running), news_(news) {}

  // These services leave together. `unloads`: the component's name, of which
  // everybody is told; empty: nobody is. `promise` is kept once all instances
  // are gone; it may be empty.
  void depart(std::vector<ServicePointer> services, const std::string& unloads,
              component_promise promise);
  // An instance may have finished.
  void idle(InstanceId instance);
  // Nothing happens where the departure has finished before.
  void drain_over(const actors::drain_over& what);
  // An instance of a service that leaves has ended.
  void instance_ended(const ServicePointer& service);

private:
  struct Departure {
    std::vector<ServicePointer> services;
    std::string unloads;
    component_promise promise;
    DueTicket due; // of drain_over
  };
  using Departing = std::map<std::uint64_t, Departure>::iterator;

  // The end of the map where the service departs in none.
  Departing departure_of(const ServicePointer& service);
  void stop_accepting(const ServicePointer& service);
  // Those of its instances that have nothing left to do are told so.
  void stop_finished(const Departure& departure);
  bool hand_on(Service& service);
  // Ends the departure if nothing of it is left; `departing` is gone then.
  void hand_on_all(Departing departing);
  void finish(Departure departure);

  const supervisor_actor::pointer self_;
  RunningInstances& running_;
  const ComponentNews& news_;
  std::map<std::uint64_t, Departure> departures_;
  std::uint64_t last_ = 0;
};

} // namespace parlour::actors
