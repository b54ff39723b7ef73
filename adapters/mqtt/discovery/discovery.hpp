// Reads what devices announce by Home Assistant's MQTT discovery: retained
// messages in JSON on the topics
//
//   <prefix>/<kind>/[<node>/]<object>/config   one thing
//   <prefix>/device/[<node>/]<object>/config   a device with several things
//
// Of the kinds, light, switch, lock, cover, climate, sensor, binary_sensor and
// event are read. Others, and what a device has for its own care (an
// entity_category), are passed over.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/mqtt/discovery/entity.hpp"
#include "adapters/mqtt/discovery/payload.hpp"

namespace parlour::adapters::mqtt {

// The topics under which devices are announced, as filters to subscribe to.
std::vector<std::string> discovery_filters(const std::string& prefix);

// The kind in a discovery topic; nothing for any other topic.
std::optional<std::string> discovered_kind(const std::string& prefix,
                                           const std::string& topic);

struct Discovery {
  std::vector<Entity> entities;
  // Why some of them cannot be used, a sentence for each.
  std::vector<std::string> mistakes;
};

// `id` is the topic. A payload that is no JSON object is a mistake.
Discovery read_discovery(const std::string& id, const std::string& kind,
                         const Payload& payload);

} // namespace parlour::adapters::mqtt
