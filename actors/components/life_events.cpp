#include "actors/components/life_events.hpp"

#include <cassert>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace parlour::actors {

void LifeEvents::begin(InstanceId id) {
  instances_[id] = InstanceState::starting;
}

InstanceState LifeEvents::state_of(InstanceId id) const {
  const auto found = instances_.find(id);
  return found == instances_.end() ? InstanceState::gone : found->second;
}

void LifeEvents::happens(InstanceId id, InstanceEvent event,
                         const Cause& cause) {
  queue(OfInstance{id, event, cause});
}

void LifeEvents::happens(const ServicePointer& service, ServiceEvent event,
                         const Cause& cause) {
  queue(OfService{service, event, cause});
}

void LifeEvents::report(std::function<void()> report) {
  reports_.push_back(std::move(report));
}

void LifeEvents::queue(Item item) {
  raised_.push_back(std::move(item));
  if (taking_)
    return;
  take_all();
  make_reports();
}

// What a transition has raised comes before what was queued already.
void LifeEvents::take_all() {
  taking_ = true;
  while (!raised_.empty() || !queue_.empty()) {
    queue_.insert(queue_.begin(), std::make_move_iterator(raised_.begin()),
                  std::make_move_iterator(raised_.end()));
    raised_.clear();
    const auto item = std::move(queue_.front());
    queue_.pop_front();
    std::visit([this](const auto& one) { take(one); }, item);
  }
  taking_ = false;
}

void LifeEvents::take(const OfInstance& item) {
  const auto& [id, event, cause] = item;
  const auto found = instances_.find(id);
  if (found == instances_.end())
    return; // gone, where everything is possible and nothing follows
  const auto& row = transition(found->second, event);
  if (!row.next)
    return impossible(fmt::format("instance {}", id), row.state, event);
  found->second = *row.next;
  for (auto deed : row.deeds)
    deeds_.carry_out(deed, id, cause);
  if (*row.next == InstanceState::gone)
    instances_.erase(id);
}

void LifeEvents::take(const OfService& item) {
  const auto& [service, event, cause] = item;
  const auto& row = transition(service->state, event);
  if (!row.next)
    return impossible(service->name(), row.state, event);
  service->state = *row.next;
  for (auto deed : row.deeds)
    deeds_.carry_out(deed, service, cause);
}

// Not from within another report: the first may be in the middle of something.
void LifeEvents::make_reports() {
  if (std::exchange(reporting_, true))
    return;
  while (!reports_.empty()) {
    const auto report = std::move(reports_.front());
    reports_.pop_front();
    report();
  }
  reporting_ = false;
}

template <class State, class Event>
void LifeEvents::impossible(const std::string& who, State state, Event event) {
  deeds_.log_error(fmt::format("{}: '{}' cannot happen in state '{}'", who,
                               name_of(event), name_of(state)));
  assert(false && "the table of its life says that this cannot happen");
}

} // namespace parlour::actors
