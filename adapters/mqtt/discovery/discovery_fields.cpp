#include "adapters/mqtt/discovery/discovery_fields.hpp"

#include <unordered_map>
#include <utility>

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters::mqtt {

namespace {

using Names = std::unordered_map<std::string, std::string>;

// Long names by their abbreviations.
const Names& field_names() {
  static const Names names = {
#define FIELD(name, abbreviation) {abbreviation, #name}, {#name, #name},
#define DEVICE_FIELD(name, abbreviation)
#include "adapters/mqtt/discovery/discovery_fields.def"
#undef FIELD
#undef DEVICE_FIELD
  };
  return names;
}

const Names& device_field_names() {
  static const Names names = {
#define FIELD(name, abbreviation)
#define DEVICE_FIELD(name, abbreviation) {abbreviation, #name}, {#name, #name},
#include "adapters/mqtt/discovery/discovery_fields.def"
#undef FIELD
#undef DEVICE_FIELD
  };
  return names;
}

// Words that YAML takes for booleans are written so in hand-made messages.
bool is_true(const Value& value) {
  const auto text = text_of(value);
  return text == "True" || text == "true" || text == "1" || text == "on";
}

} // namespace

// The base topic of the device holds for its parts, unless they have their own.
Fields::Fields(const Map& message, const Fields* outside) : outside_(outside) {
  for (const auto& [key, value] : message.entries())
    if (key == "~" && value.if_string())
      base_ = value.text();
    else if (const auto known = field_names().find(key);
             known != field_names().end())
      fields_[known->second] = &value;
  if (base_.empty() && outside)
    base_ = outside->base_;
}

const Value* Fields::find(const std::string& name) const {
  const auto found = fields_.find(name);
  if (found != fields_.end())
    return found->second;
  return outside_ ? outside_->find(name) : nullptr;
}

// A list or an object is no text.
std::optional<std::string> Fields::text(const std::string& name) const {
  const auto* value = find(name);
  if (!value || value->is_unknown() || value->if_list() || value->if_map())
    return {};
  return text_of(*value);
}

std::string Fields::text(const std::string& name,
                         const std::string& otherwise) const {
  return text(name).value_or(otherwise);
}

bool Fields::truth(const std::string& name, bool otherwise) const {
  const auto* value = find(name);
  return value ? is_true(*value) : otherwise;
}

double Fields::number(const std::string& name, double otherwise) const {
  const auto said = text(name);
  return said ? parse_number(*said).number_or(otherwise) : otherwise;
}

// With "~": "home/lamp", "~/set" is "home/lamp/set".
std::string Fields::whole_topic(const std::string& topic) const {
  if (base_.empty())
    return topic;
  if (topic.starts_with('~'))
    return base_ + topic.substr(1);
  if (topic.ends_with('~'))
    return topic.substr(0, topic.size() - 1) + base_;
  return topic;
}

// A wildcard in a topic would make other devices' messages this one's.
std::string Fields::topic(const std::string& name) {
  auto topic = whole_topic(text(name, ""));
  if (topic.size() > 65'535 || topic.find_first_of("#+") != topic.npos ||
      topic.find('\0') != topic.npos || find_invalid_utf8(topic))
    note("the " + name + " '" + topic.substr(0, 100) +
         "' has characters that it must not have");
  return topic;
}

ValueTemplate Fields::value_template(const std::string& name) {
  const auto said = text(name);
  if (!said || said->empty())
    return {};
  auto made = ValueTemplate::parse(*said);
  if (made)
    return std::move(*made);
  note(made.error().message);
  return {};
}

Source Fields::source(const std::string& topic, const std::string& value) {
  return {this->topic(topic), value_template(value)};
}

// Fields of the device stand in a map of their own, with short names of their
// own.
std::string Fields::device_text(const std::string& name) const {
  const auto* device = find("device");
  if (!device || !device->if_map())
    return {};
  for (const auto& [key, value] : device->if_map()->entries()) {
    const auto known = device_field_names().find(key);
    if (known != device_field_names().end() && known->second == name &&
        value.if_string())
      return value.text();
  }
  return {};
}

// One topic, or a list of objects with a topic each.
// Both forms may be there; then all of them count.
std::vector<AvailabilitySource> Fields::availability() {
  std::vector<AvailabilitySource> all;
  if (auto one = source("availability_topic", "availability_template");
      !one.topic.empty())
    all.push_back({std::move(one), text("payload_available", "online"),
                   text("payload_not_available", "offline")});
  const auto* list = find("availability");
  if (!list || !list->if_list())
    return all;
  for (const auto& each : *list->if_list()) {
    if (!each.if_map())
      continue;
    Fields fields(*each.if_map());
    if (fields.base_.empty())
      fields.base_ = base_;
    auto source = fields.source("topic", "value_template");
    note(fields.mistake());
    if (!source.topic.empty())
      all.push_back({std::move(source),
                     fields.text("payload_available", "online"),
                     fields.text("payload_not_available", "offline")});
  }
  return all;
}

void Fields::note(const std::string& mistake) {
  if (mistake_.empty())
    mistake_ = mistake;
}

} // namespace parlour::adapters::mqtt
