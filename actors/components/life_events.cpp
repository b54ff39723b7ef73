#include "actors/components/life_events.hpp"

#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace parlour::actors {

namespace {

template <class Row, class Event>
Impossible impossible(const std::string& who, const Row& row, Event event) {
  return {fmt::format("{}: '{}' cannot happen in state '{}'", who,
                      name_of(event), name_of(row.state))};
}

} // namespace

void LifeEvents::begin(InstanceId id) {
  instances_[id] = InstanceState::starting;
}

InstanceState LifeEvents::state_of(InstanceId id) const {
  const auto found = instances_.find(id);
  return found == instances_.end() ? InstanceState::gone : found->second;
}

void LifeEvents::happens(InstanceId id, InstanceEvent event,
                         const Cause& cause) {
  raised_.emplace_back(OfInstance{id, event, cause});
}

void LifeEvents::happens(const ServicePointer& service, ServiceEvent event,
                         const Cause& cause) {
  raised_.emplace_back(OfService{service, event, cause});
}

// What a transition has raised comes before what was queued already.
std::optional<Transition> LifeEvents::next() {
  std::optional<Transition> made;
  while (!made && !(raised_.empty() && queue_.empty())) {
    queue_.insert(queue_.begin(), std::make_move_iterator(raised_.begin()),
                  std::make_move_iterator(raised_.end()));
    raised_.clear();
    const auto item = std::move(queue_.front());
    queue_.pop_front();
    made =
        std::visit([this](const auto& one) { return this->take(one); }, item);
  }
  return made;
}

// A message about an instance may arrive when it is gone, as its host's thread
// knows nothing of that.
std::optional<Transition> LifeEvents::take(const OfInstance& item) {
  const auto found = instances_.find(item.id);
  if (found == instances_.end())
    return std::nullopt; // gone: everything is possible, nothing follows
  const auto& row = transition(found->second, item.event);
  if (!row.next)
    return impossible(fmt::format("instance {}", item.id), row, item.event);
  if (*row.next == InstanceState::gone)
    instances_.erase(found);
  else
    found->second = *row.next;
  return InstanceDeeds{item.id, row.deeds, item.cause};
}

std::optional<Transition> LifeEvents::take(const OfService& item) {
  const auto& row = transition(item.service->state, item.event);
  if (!row.next)
    return impossible(item.service->name(), row, item.event);
  item.service->state = *row.next;
  return ServiceDeeds{item.service, row.deeds, item.cause};
}

} // namespace parlour::actors
