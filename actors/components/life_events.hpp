// LifeEvents: takes the events of services and of their instances one at a
// time, by service_life.def and instance_life.def. A deed may lead to further
// events: these are queued and taken as soon as the transition is over, before
// what was queued earlier. So no transition begins inside of another, and what
// follows from an event has happened when the next one is taken.
//
// Pure: the deeds are carried out by whoever implements LifeDeeds. For one
// thread.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "actors/components/deployment.hpp"
#include "actors/components/instance_life.hpp"

namespace parlour::actors {

// What an event brings with it, as far as its deeds need it.
struct Cause {
  Error error = {ErrorKind::settings, {}, {}};
  Milliseconds pause{0};   // until it is tried again
  InstanceId instance = 0; // that has started
};

class LifeDeeds {
public:
  virtual ~LifeDeeds() = default;

  // The state is the next one already.
  virtual void carry_out(InstanceDeed deed, InstanceId id,
                         const Cause& cause) = 0;
  virtual void carry_out(ServiceDeed deed, const ServicePointer& service,
                         const Cause& cause) = 0;
  // A bug of who says what has happened; debug builds end after it.
  virtual void log_error(const std::string& text) = 0;
};

class LifeEvents {
public:
  explicit LifeEvents(LifeDeeds& deeds) : deeds_(deeds) {}
  LifeEvents(const LifeEvents&) = delete;
  LifeEvents& operator=(const LifeEvents&) = delete;

  // An instance whose life begins. One that nobody has begun is gone.
  void begin(InstanceId id);
  InstanceState state_of(InstanceId id) const;

  // When these return all that follows has happened, too, unless they are
  // called by a deed. What a table calls impossible is logged and changes
  // nothing.
  void happens(InstanceId id, InstanceEvent event, const Cause& cause = {});
  void happens(const ServicePointer& service, ServiceEvent event,
               const Cause& cause = {});

  // By a deed: calls this when no event is left, one report after the other.
  // What a report says has happened has happened when the call returns.
  void report(std::function<void()> report);

private:
  struct OfInstance {
    InstanceId id;
    InstanceEvent event;
    Cause cause;
  };
  struct OfService {
    ServicePointer service;
    ServiceEvent event;
    Cause cause;
  };
  using Item = std::variant<OfInstance, OfService>;

  void queue(Item item);
  void take_all();
  void take(const OfInstance& item);
  void take(const OfService& item);
  void make_reports();
  template <class State, class Event>
  void impossible(const std::string& who, State state, Event event);

  LifeDeeds& deeds_;
  std::map<InstanceId, InstanceState> instances_; // that are not gone
  std::deque<Item> queue_;
  std::vector<Item> raised_; // by the transition that is being made
  std::deque<std::function<void()>> reports_;
  bool taking_ = false;
  bool reporting_ = false;
};

} // namespace parlour::actors
