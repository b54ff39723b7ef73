#include "actors/components/departures.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

namespace parlour::actors {

// Instances that have nothing to do stop at once; the others report when they
// have finished (instance_idle), or are stopped when the time is over.
void Departures::depart(std::vector<ServicePointer> services,
                        const std::string& unloads, component_promise promise) {
  for (const auto& service : services)
    stop_accepting(service);
  const auto id = ++last_;
  const auto departing =
      departures_
          .emplace(id,
                   Departure{std::move(services), unloads, std::move(promise),
                             running_.ticket(drain_time)})
          .first;
  self_->delayed_send(self_, drain_time, actors::drain_over{id});
  stop_finished(departing->second);
  hand_on_all(departing);
}

// The mailbox stays open where a successor has it by now.
void Departures::stop_accepting(const ServicePointer& service) {
  assert(departure_of(service) == departures_.end() && "it departs once");
  if (!service->handed_on)
    service->component->mailbox->close("is being unloaded");
  running_.happens(service, ServiceEvent::leave);
  running_.happens_to_all(*service, InstanceEvent::drain);
}

void Departures::idle(InstanceId instance) {
  const auto service = running_.service_of(instance);
  const auto departing = service ? departure_of(service) : departures_.end();
  if (departing == departures_.end())
    return;
  stop_finished(departing->second);
  hand_on_all(departing);
}

// What the instances still owe is answered by a failure when they have stopped
// (instance_life.def).
void Departures::drain_over(const actors::drain_over& what) {
  const auto found = departures_.find(what.departure);
  if (found == departures_.end())
    return;
  found->second.due = {};
  for (const auto& service : found->second.services)
    running_.happens_to_all(*service, InstanceEvent::stop);
  hand_on_all(found);
}

void Departures::instance_ended(const ServicePointer& service) {
  if (const auto found = departure_of(service); found != departures_.end())
    hand_on_all(found);
}

Departures::Departing Departures::departure_of(const ServicePointer& service) {
  return std::ranges::find_if(departures_, [&](const auto& entry) {
    return std::ranges::count(entry.second.services, service) != 0;
  });
}

// To hear that it has finished may end an instance here and now.
void Departures::stop_finished(const Departure& departure) {
  for (const auto& service : departure.services) {
    const auto ids = service->instances; // some end here
    for (auto instance : ids)
      if (running_.has_finished(instance))
        running_.happens(instance, InstanceEvent::finished);
  }
}

// Once all of its instances stop, its successors have the mailbox. True when
// none is left.
bool Departures::hand_on(Service& service) {
  const auto left = service.instances;
  if (std::ranges::all_of(left, [&](auto instance) {
        return running_.state_of(instance) == InstanceState::stopping;
      }))
    running_.begin(std::exchange(service.successors, {}));
  return left.empty();
}

void Departures::hand_on_all(Departing departing) {
  bool is_gone = true;
  for (const auto& service : departing->second.services)
    is_gone = hand_on(*service) && is_gone;
  if (is_gone)
    finish(std::move(departures_.extract(departing).mapped()));
}

// All instances are gone: what still waits in a mailbox gets no answer but
// this.
void Departures::finish(Departure departure) {
  for (const auto& service : departure.services)
    if (!service->handed_on)
      news_.answer_what_waits(*service, service->over ? "its session is over"
                                                      : "it was unloaded");
  if (!departure.unloads.empty())
    news_.tell("ComponentDown", {departure.unloads, "unloaded"});
  departure.promise.deliver(component_done{});
}

} // namespace parlour::actors
