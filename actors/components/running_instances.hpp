// RunningInstances: the instances of a node's components, and the services that
// they work for. What becomes of either at an event says its table
// (life_events.hpp); this carries the deeds out. Lives on the supervisor's
// thread.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "actors/components/component_news.hpp"
#include "actors/components/life_events.hpp"

namespace parlour::actors {

// Who decides what a whole component does; told on the supervisor's thread,
// once no event is left to take.
class ServiceListener {
public:
  virtual ~ServiceListener() = default;

  // An instance of one that is coming has started.
  virtual void on_instance_started(const ServicePointer& service) = 0;
  // One that is coming does not start.
  virtual void on_activation_failed(const ServicePointer& service,
                                    const Error& error) = 0;
  // An instance of one that leaves has ended.
  virtual void on_instance_ended(const ServicePointer& service) = 0;
  // What is called without a mailbox is another object now: told at once,
  // before messages are routed to it.
  virtual void on_direct_changed() = 0;
};

class RunningInstances : private LifeDeeds {
public:
  RunningInstances(supervisor_actor::pointer self,
                   const SupervisionParts& parts, ComponentNews& news,
                   ServiceListener& listener)
      : self_(self), parts_(parts), news_(news), listener_(listener) {}

  // -- services --------------------------------------------------------------

  // As LifeEvents says.
  void happens(const ServicePointer& service, ServiceEvent event,
               const Cause& cause = {}) {
    events_.happens(service, event, cause);
  }
  // The instances that it is to have, once those that stop have stopped: both
  // may want the same device.
  void fill_up(const ServicePointer& service);
  // From now on none is made.
  void close() {
    closed_ = true;
  }

  // -- instances -------------------------------------------------------------

  void happens(InstanceId id, InstanceEvent event, const Cause& cause = {}) {
    events_.happens(id, event, cause);
  }
  void happens_to_all(const Service& service, InstanceEvent event,
                      const Cause& cause = {});
  std::vector<InstanceId> instances_of(const Service& service) const;
  void stop_all();
  InstanceState state_of(InstanceId id) const {
    return events_.state_of(id);
  }
  // Null for one that is gone.
  ServicePointer service_of(InstanceId id) const;
  // Whether it owes no answer, is in no call, and nothing waits for it.
  bool has_finished(InstanceId id) const;
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
  struct Entry {
    std::shared_ptr<Instance> instance;
    component_host_actor host;
    ServicePointer service;
    Milliseconds deadline{0}; // of the call that it is in
  };

  void make_instance(const ServicePointer& service);
  component_host_actor host_for(const std::shared_ptr<Instance>& instance);

  // -- LifeDeeds
  void carry_out(InstanceDeed deed, InstanceId id, const Cause& cause) override;
  void carry_out(ServiceDeed deed, const ServicePointer& service,
                 const Cause& cause) override;
  void log_error(const std::string& text) override {
    news_.log("error: " + text);
  }

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
  ServiceListener& listener_;
  LifeEvents events_{*this};
  std::map<InstanceId, Entry> entries_;
  InstanceId last_instance_ = 0;
  std::uint64_t last_trial_ = 0;
  bool closed_ = false;
  std::string last_error_;
};

} // namespace parlour::actors
