// InstanceState, InstanceEvent, InstanceDeed: the life of one instance of a
// component, as instance_life.def tells it. Pure: running_instances.hpp carries
// the deeds out.
#pragma once

#include <cstdint>
#include <string_view>

#include "actors/support/life_table.hpp"

namespace parlour::actors {

#define INSTANCE_STATE(name, sentence) name,
enum class InstanceState : std::uint8_t {
#include "actors/components/instance_life.def"
};

#define INSTANCE_EVENT(name, sentence) name,
enum class InstanceEvent : std::uint8_t {
#include "actors/components/instance_life.def"
};

#define INSTANCE_DEED(name, sentence) name,
enum class InstanceDeed : std::uint8_t {
#include "actors/components/instance_life.def"
};

using InstanceRow = LifeRow<InstanceState, InstanceEvent, InstanceDeed>;

// The row of this pair; one without a next state is a bug of who asks.
const InstanceRow& transition(InstanceState state, InstanceEvent event);

// "working".
std::string_view name_of(InstanceState state);
std::string_view name_of(InstanceEvent event);

} // namespace parlour::actors
