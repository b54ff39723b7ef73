#include "actors/components/service_life.hpp"

#include <iterator>

namespace parlour::actors {

namespace {

constexpr std::string_view states[] = {
#define SERVICE_STATE(name, sentence) #name,
#include "actors/components/service_life.def"
};

constexpr std::string_view events[] = {
#define SERVICE_EVENT(name, sentence) #name,
#include "actors/components/service_life.def"
};

using Table = LifeTable<ServiceRow, std::size(states), std::size(events)>;

// A constant: that each pair has its row is checked when this is compiled.
constexpr Table make_table() {
  using State = ServiceState;
  using Event = ServiceEvent;
  using enum ServiceDeed;
  return {{{
#define SERVICE_ROW(state, event, next, ...)                                   \
  {State::state, Event::event, State::next, {__VA_ARGS__}},
#define SERVICE_NEVER(state, event) {State::state, Event::event, std::nullopt},
#include "actors/components/service_life.def"
  }}};
}

constexpr Table table = make_table();
static_assert(table.is_complete(), "a row is missing, or not in its place");

} // namespace

const ServiceRow& transition(ServiceState state, ServiceEvent event) {
  return table.at(state, event);
}

std::string_view name_of(ServiceState state) {
  return states[static_cast<std::size_t>(state)];
}

std::string_view name_of(ServiceEvent event) {
  return events[static_cast<std::size_t>(event)];
}

} // namespace parlour::actors
