#include "adapters/mqtt/device_table.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters::mqtt {

namespace {

using SourceState = AvailabilitySource::State;

// Its topics, each once.
std::vector<std::string> topics_of(const Entity& entity) {
  std::vector<std::string> topics;
  const auto add = [&](const std::string& topic) {
    if (!topic.empty() && std::ranges::find(topics, topic) == topics.end())
      topics.push_back(topic);
  };
  add(entity.state.topic);
  for (const auto& one : entity.availability)
    add(one.source.topic);
  return topics;
}

// A device that suggests no area may have the room in its name.
bool is_in(const Device& device, const Words& room) {
  return device.area_words.empty() ? contains(device.all_words, room)
                                   : device.area_words == room;
}

// How well a name that is on no list fits: 0 for not at all.
int fit(const Device& device, const Words& asked) {
  if (words_of(device.entity.kind) == asked)
    return 3;
  if (device.name_words == asked)
    return 2;
  return contains(device.all_words, asked) ? 1 : 0;
}

} // namespace

// What has not been heard of counts as there: it may never tell.
bool Device::is_available() const {
  const auto is_away = [](SourceState each) {
    return each == SourceState::unavailable;
  };
  switch (entity.availability_mode) {
  case AvailabilityMode::all:
    return std::ranges::none_of(sources, is_away);
  case AvailabilityMode::any:
    return sources.empty() || !std::ranges::all_of(sources, is_away);
  case AvailabilityMode::latest:
    break;
  }
  return !latest_source || !is_away(sources[*latest_source]);
}

Value Device::state_at(Moment now) const {
  const bool expired =
      entity.expires_after && now - told > *entity.expires_after;
  return expired ? Value() : state;
}

DeviceTable::DeviceTable(const DeviceList& list) : list_(list) {
  for (const auto& entity : list.entities)
    set(entity.id, {entity});
}

// -- what is announced --------------------------------------------------------

// A thing that is announced again, as after a restart of its hub, is the same
// thing: its state stays, as long as it is read from the same topic.
bool DeviceTable::set(const std::string& message,
                      std::vector<Entity> entities) {
  const auto former = by_message_.find(message);
  const auto others = devices_.size() -
                      (former == by_message_.end() ? 0 : former->second.size());
  // What is known stays as it was.
  if (others + entities.size() > max_devices)
    return false;
  std::map<std::string, Device> before;
  if (const auto known = by_message_.extract(message))
    for (const auto& id : known.mapped()) {
      forget(id);
      before.insert(devices_.extract(id));
    }
  for (auto& entity : entities) {
    auto device = device_of(std::move(entity));
    const auto id = device.entity.id;
    if (devices_.contains(id))
      continue;
    const auto old = before.find(id);
    if (old != before.end() &&
        old->second.entity.state.topic == device.entity.state.topic) {
      device.state = old->second.state;
      device.told = old->second.told;
      if (old->second.sources.size() == device.sources.size()) {
        device.sources = old->second.sources;
        device.latest_source = old->second.latest_source;
      }
    }
    read(device);
    by_message_[message].push_back(id);
    devices_.emplace(id, std::move(device));
  }
  return true;
}

Device DeviceTable::device_of(Entity entity) const {
  Device made;
  made.name_words = words_of(entity.name);
  made.all_words = words_of(entity.device + " " + entity.name);
  made.area_words = words_of(entity.area);
  made.sources.resize(entity.availability.size());
  made.entity = std::move(entity);
  for (const auto& one : list_.devices)
    if (means(one, made))
      made.listed.push_back(&one);
  return made;
}

// The class "temperature" may also be a word of the device's name.
bool DeviceTable::means(const ListedDevice& listed,
                        const Device& device) const {
  const auto& entity = device.entity;
  return listed.kind == entity.kind &&
         (listed.device_class.empty() ||
          listed.device_class == entity.device_class ||
          contains(device.all_words, listed.class_words)) &&
         (listed.room == "*" || is_in(device, listed.room_words));
}

// A topic that was given up and is wanted again, before anybody has asked for
// the changes, is no change.
void DeviceTable::read(const Device& device) {
  for (auto& topic : topics_of(device.entity)) {
    auto& readers = by_topic_[topic];
    if (readers.empty() && std::erase(changes_.removed, topic) == 0)
      changes_.added.push_back(topic);
    readers.push_back(device.entity.id);
  }
}

void DeviceTable::forget(const std::string& id) {
  for (const auto& topic : topics_of(devices_.at(id).entity)) {
    auto& readers = by_topic_[topic];
    std::erase(readers, id);
    if (!readers.empty())
      continue;
    by_topic_.erase(topic);
    if (std::erase(changes_.added, topic) == 0)
      changes_.removed.push_back(topic);
  }
}

DeviceTable::Changes DeviceTable::changes() {
  return std::exchange(changes_, {});
}

std::vector<std::string> DeviceTable::topics() const {
  std::vector<std::string> topics;
  for (const auto& [topic, readers] : by_topic_)
    topics.push_back(topic);
  return topics;
}

// -- what is asked ------------------------------------------------------------

bool DeviceTable::is_listed(const Words& device) const {
  return std::ranges::any_of(list_.devices, [&](const ListedDevice& one) {
    return one.device_words == device;
  });
}

// Only the best ones are found: a thing whose kind is "light" comes before one
// that is called "night light". A name of the list means what is listed and
// nothing else.
std::vector<Device*> DeviceTable::find(const std::string& device,
                                       const std::string& room) {
  const auto asked = words_of(device);
  const auto where = words_of(room);
  const bool listed = is_listed(asked);
  std::vector<Device*> found;
  int best = 1;
  for (auto& entry : devices_) {
    auto& each = entry.second;
    const bool is_meant =
        std::ranges::any_of(each.listed, [&](const ListedDevice* one) {
          return one->device_words == asked &&
                 (one->room_words == where ||
                  (one->room == "*" && is_in(each, where)));
        });
    const int fits = listed               ? (is_meant ? 4 : 0)
                     : is_in(each, where) ? fit(each, asked)
                                          : 0;
    if (fits > best)
      found.clear();
    best = std::max(best, fits);
    if (fits == best)
      found.push_back(&each);
  }
  return found;
}

Device* DeviceTable::find(const std::string& id) {
  const auto found = devices_.find(id);
  return found == devices_.end() ? nullptr : &found->second;
}

std::vector<Device*> DeviceTable::readers(const std::string& topic) {
  std::vector<Device*> found;
  if (const auto known = by_topic_.find(topic); known != by_topic_.end())
    for (const auto& id : known->second)
      found.push_back(&devices_.at(id));
  return found;
}

// Without a list the device's own words count, and its kind where it has no
// name.
std::optional<Spoken> DeviceTable::spoken(const Device& device) const {
  const auto& entity = device.entity;
  if (!device.listed.empty()) {
    const auto& one = *device.listed.front();
    return Spoken{one.device, one.room == "*" ? entity.area : one.room};
  }
  if (!list_.devices.empty())
    return {};
  return Spoken{entity.name.empty() ? entity.kind : entity.name, entity.area};
}

std::vector<std::string> DeviceTable::in_room(const std::string& room) const {
  const auto where = words_of(room);
  std::vector<std::string> names;
  for (const auto& [id, device] : devices_)
    if (const auto called = spoken(device); called && is_in(device, where))
      if (std::ranges::find(names, called->device) == names.end())
        names.push_back(called->device);
  return names;
}

std::size_t DeviceTable::spoken_of() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(devices_, [&](const auto& each) {
        return spoken(each.second).has_value();
      }));
}

} // namespace parlour::adapters::mqtt
