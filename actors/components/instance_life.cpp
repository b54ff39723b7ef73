#include "actors/components/instance_life.hpp"

#include <iterator>

namespace parlour::actors {

namespace {

constexpr std::string_view states[] = {
#define INSTANCE_STATE(name, sentence) #name,
#include "actors/components/instance_life.def"
};

constexpr std::string_view events[] = {
#define INSTANCE_EVENT(name, sentence) #name,
#include "actors/components/instance_life.def"
};

using Table = LifeTable<InstanceRow, std::size(states), std::size(events)>;

// A constant: that each pair has its row is checked when this is compiled.
constexpr Table make_table() {
  using State = InstanceState;
  using Event = InstanceEvent;
  using enum InstanceDeed;
  return {{{
#define INSTANCE_ROW(state, event, next, ...)                                  \
  {State::state, Event::event, State::next, {__VA_ARGS__}},
#define INSTANCE_NEVER(state, event) {State::state, Event::event, std::nullopt},
#include "actors/components/instance_life.def"
  }}};
}

constexpr Table table = make_table();
static_assert(table.is_complete(), "a row is missing, or not in its place");

} // namespace

const InstanceRow& transition(InstanceState state, InstanceEvent event) {
  return table.at(state, event);
}

std::string_view name_of(InstanceState state) {
  return states[static_cast<std::size_t>(state)];
}

std::string_view name_of(InstanceEvent event) {
  return events[static_cast<std::size_t>(event)];
}

} // namespace parlour::actors
