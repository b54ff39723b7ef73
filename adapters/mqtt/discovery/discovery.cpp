#include "adapters/mqtt/discovery/discovery.hpp"

#include <utility>

#include "adapters/mqtt/discovery/entity_kinds.hpp"

namespace parlour::adapters::mqtt {

namespace {

constexpr std::string_view whole_device = "device";
constexpr std::string_view ending = "/config";
// How many things one message may announce.
// More than any device has; a message may be 256 KB long.
constexpr std::size_t max_parts = 200;

// Switched off by the device's maker, or only for its care.
bool is_hidden(const Fields& fields) {
  return !fields.truth("enabled_by_default", true) ||
         fields.text("entity_category");
}

// A thing with a mistake is left out as a whole: a switch that is half
// understood would do the wrong thing.
void read_one(Discovery& found, const std::string& id, const std::string& kind,
              Fields& fields) {
  if (!is_known_kind(kind) || is_hidden(fields))
    return;
  auto entities = entities_of(id, kind, fields);
  if (!fields.mistake().empty()) {
    found.mistakes.push_back(id + ": " + fields.mistake());
    return;
  }
  for (auto& entity : entities)
    found.entities.push_back(std::move(entity));
}

// The parts share the device, its availability and the base topic.
//
//   {"dev": {"name": "Hub"}, "~": "home/hub",
//    "cmps": {"lamp": {"p": "light", "cmd_t": "~/lamp"},
//             "door": {"p": "lock", "cmd_t": "~/door"}}}
void read_parts(Discovery& found, const std::string& id, const Fields& whole) {
  const auto* parts = whole.find("components");
  if (!parts || !parts->if_map() || parts->if_map()->size() > max_parts) {
    found.mistakes.push_back(id + ": a device announces 1 to " +
                             std::to_string(max_parts) + " components");
    return;
  }
  for (const auto& [name, part] : parts->if_map()->entries()) {
    if (!part.if_map())
      continue;
    Fields fields(*part.if_map(), &whole);
    auto part_id = id;
    part_id.append("#").append(name);
    read_one(found, part_id, fields.text("platform", ""), fields);
  }
}

} // namespace

std::vector<std::string> discovery_filters(const std::string& prefix) {
  return {prefix + "/+/+/config", prefix + "/+/+/+/config"};
}

// "homeassistant/light/kitchen/config" is a "light".
std::optional<std::string> discovered_kind(const std::string& prefix,
                                           const std::string& topic) {
  if (!topic.starts_with(prefix + "/") || !topic.ends_with(ending))
    return {};
  const auto start = prefix.size() + 1;
  const auto end = topic.find('/', start);
  return topic.substr(start, end - start);
}

// A kind that is not read is passed over before its payload is looked at.
Discovery read_discovery(const std::string& id, const std::string& kind,
                         const Payload& payload) {
  Discovery found;
  if (kind != whole_device && !is_known_kind(kind))
    return found;
  const auto* json = payload.json();
  if (!json || !json->if_map()) {
    found.mistakes.push_back(id + ": this is no JSON object");
    return found;
  }
  Fields fields(*json->if_map());
  if (kind == whole_device)
    read_parts(found, id, fields);
  else
    read_one(found, id, kind, fields);
  return found;
}

} // namespace parlour::adapters::mqtt
