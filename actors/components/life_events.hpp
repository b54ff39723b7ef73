// LifeEvents: what follows from the events of services and of their instances,
// by service_life.def and instance_life.def, one event at a time. A deed may
// lead to further events: these come as soon as the transition is over, before
// what was queued earlier. So no transition begins inside of another, and what
// follows from an event has happened when the next one is taken.
//
// Pure: who asks carries the deeds out. For one thread.
#pragma once

#include <deque>
#include <map>
#include <optional>
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

// What follows from an event; the state is the next one already.
struct InstanceDeeds {
  InstanceId id;
  Deeds<InstanceDeed> deeds;
  Cause cause;
};
struct ServiceDeeds {
  ServicePointer service;
  Deeds<ServiceDeed> deeds;
  Cause cause;
};
// The table calls the event impossible: a bug of who says that it has happened.
// Nothing changes.
struct Impossible {
  std::string text;
};
using Transition = std::variant<InstanceDeeds, ServiceDeeds, Impossible>;

// The queue is what makes the tables trustworthy: a deed such as `blame` may
// bring a service down, which stops other instances; all of that is queued, and
// each transition sees the state that the one before has left.
class LifeEvents {
public:
  // An instance whose life begins. One that nobody has begun is gone.
  void begin(InstanceId id);
  InstanceState state_of(InstanceId id) const;

  // To be taken; those of a transition's deeds before all others.
  void happens(InstanceId id, InstanceEvent event, const Cause& cause = {});
  void happens(const ServicePointer& service, ServiceEvent event,
               const Cause& cause = {});
  // Takes events until something is to be done; nothing: none is left. What is
  // to be done has to be done before the next is asked for.
  std::optional<Transition> next();

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

  static std::optional<Transition> take(const OfService& item);
  std::optional<Transition> take(const OfInstance& item);

  std::map<InstanceId, InstanceState> instances_; // that are not gone
  std::deque<Item> queue_;
  std::vector<Item> raised_; // by the transition that was made last
};

} // namespace parlour::actors
