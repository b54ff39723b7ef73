// How each kind of thing that Home Assistant knows becomes an Entity.
#pragma once

#include <string>
#include <vector>

#include "adapters/mqtt/discovery/discovery_fields.hpp"
#include "adapters/mqtt/discovery/entity.hpp"

namespace parlour::adapters::mqtt {

// Of those that are read: "camera" is none of them.
bool is_known_kind(const std::string& kind);

// The entities of one thing: mostly one, two for a heating that also measures.
// What is wrong is noted in `fields`.
std::vector<Entity> entities_of(const std::string& id, const std::string& kind,
                                Fields& fields);

} // namespace parlour::adapters::mqtt
