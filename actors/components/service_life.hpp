// ServiceState, ServiceEvent, ServiceDeed: the life of what one scope has of a
// component, as service_life.def tells it. Pure: running_instances.hpp carries
// the deeds out.
#pragma once

#include <cstdint>
#include <string_view>

#include "actors/support/life_table.hpp"

namespace parlour::actors {

#define SERVICE_STATE(name, sentence) name,
enum class ServiceState : std::uint8_t {
#include "actors/components/service_life.def"
};

#define SERVICE_EVENT(name, sentence) name,
enum class ServiceEvent : std::uint8_t {
#include "actors/components/service_life.def"
};

#define SERVICE_DEED(name, sentence) name,
enum class ServiceDeed : std::uint8_t {
#include "actors/components/service_life.def"
};

using ServiceRow = LifeRow<ServiceState, ServiceEvent, ServiceDeed>;

// The row of this pair; one without a next state is a bug of who asks.
const ServiceRow& transition(ServiceState state, ServiceEvent event);

// "backing_off".
std::string_view name_of(ServiceState state);
std::string_view name_of(ServiceEvent event);

} // namespace parlour::actors
