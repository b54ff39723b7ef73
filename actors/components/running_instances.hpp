// RunningInstances: the instances of a node's components, and the services that
// they work for. What becomes of either at an event says its table
// (life_events.hpp); this carries the deeds out. Lives on the supervisor's
// thread.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actors/components/component_news.hpp"
#include "actors/components/deployment.hpp"
#include "actors/components/life_events.hpp"

namespace parlour::actors {

// What concerns a whole component; whoever has called into RunningInstances
// takes what there is of it then.
struct ServiceReport {
  enum class What : std::uint8_t {
    instance_started,  // of one that is coming
    activation_failed, // one that is coming does not start
    instance_ended,    // of one that leaves
  };
  What what = What::instance_started;
  ServicePointer service;
  Error error; // that it does not start
};

// An instance and its host's thread are made here, and here alone they are told
// to stop. What a plug-in does in the meantime is the host's concern; what its
// component means for others, the caller's (Supervision, Placements,
// Departures).
class RunningInstances {
public:
  RunningInstances(supervisor_actor::pointer self,
                   const SupervisionParts& parts, ComponentNews& news,
                   const Deployments& deployments)
      : self_(self), parts_(parts), news_(news), deployments_(deployments) {}

  // The next report; nothing: there is none.
  std::optional<ServiceReport> take_report();

  // -- services --------------------------------------------------------------

  // When these return all that follows has happened, too, unless they are
  // called by a deed: then it comes when its transition is over. What a table
  // calls impossible is logged and changes nothing.
  void happens(const ServicePointer& service, ServiceEvent event,
               const Cause& cause = {});
  void happens(InstanceId id, InstanceEvent event, const Cause& cause = {});
  // The instances that it is to have, once those that stop have stopped: both
  // may want the same device.
  void fill_up(const ServicePointer& service);
  // From now on none is made.
  void close() {
    closed_ = true;
  }

  // -- instances -------------------------------------------------------------

  void happens_to_all(const Service& service, InstanceEvent event,
                      const Cause& cause = {});
  void stop_all();
  InstanceState state_of(InstanceId id) const {
    return events_.state_of(id);
  }
  // Null for one that is gone.
  ServicePointer service_of(InstanceId id) const;
  // Whether it owes no answer, is in no call, and nothing waits for it.
  bool has_finished(InstanceId id) const;
  // Whether one of its instances knows what the scripts say of language.
  bool has_read_language(const Service& service) const;
  // Those that work take messages from now on.
  void begin(const std::vector<InstanceId>& instances);
  // What the plug-in of an instance says of itself: its component, also a pool,
  // takes messages, or takes none.
  void available(InstanceId id, bool is_available);
  // Whether its calls return; asks again by itself while it is called.
  void watch(const watch_instance& what);

  // Of the last that failed, with its name; empty: none has.
  const std::string& last_error() const {
    return last_error_;
  }

  // -- time ------------------------------------------------------------------

  // So that virtual time stops there, and nobody thinks that nothing is due.
  DueTicket ticket(Milliseconds delay) const;

private:
  // One instance that is not gone, with the actor that calls it.
  struct Entry {
    std::shared_ptr<Instance> instance;
    component_host_actor host;
    ServicePointer service;
    Milliseconds deadline{0}; // of the call that it is in
  };

  void make_instance(const ServicePointer& service);
  component_host_actor host_for(const std::shared_ptr<Instance>& instance);

  // Makes transitions until no event is left.
  void take_events();
  void carry_out(const InstanceDeeds& deeds);
  void carry_out(const ServiceDeeds& deeds);
  void carry_out(const Impossible& what);
  void carry_out(InstanceDeed deed, InstanceId id, const Cause& cause);
  void carry_out(ServiceDeed deed, const ServicePointer& service,
                 const Cause& cause);

  void enlist(const Entry& entry);
  void begin_draining(const Entry& entry);
  void stop_plugin(const Entry& entry);
  void abandon(const Entry& entry);
  void answer_failure(const Entry& entry, const std::string& reason);
  void remove(InstanceId id);
  void add_worker(const Service& service, const Entry& entry);
  void count_failure(const ServicePointer& service, const Cause& cause);
  void take_down(Service& service, const Cause& cause);
  void try_later(Service& service, Milliseconds pause);

  const supervisor_actor::pointer self_;
  const SupervisionParts& parts_;
  ComponentNews& news_;
  const Deployments& deployments_;
  LifeEvents events_;
  bool takes_events_ = false;
  std::deque<ServiceReport> reports_;
  std::map<InstanceId, Entry> entries_;
  InstanceId last_instance_ = 0;
  std::uint64_t last_trial_ = 0;
  bool closed_ = false;
  std::string last_error_;
};

} // namespace parlour::actors
