// DeviceTable knows all things that have been announced: what they said last,
// whether they are there, and how the application calls them.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "adapters/mqtt/device_list.hpp"
#include "adapters/mqtt/discovery/entity.hpp"

namespace parlour::adapters::mqtt {

using Moment = std::chrono::steady_clock::time_point;

// A thing and what is known of it.
// Owned by the table; requests find it anew by its id each time.
struct Device {
  Entity entity;
  // Those rows of the list that mean it.
  std::vector<const ListedDevice*> listed;
  Words name_words; // its own name
  Words all_words;  // with the device's name
  Words area_words; // empty: none was suggested
  Value state = {}; // unknown: not told yet
  Moment told = {}; // when
  std::vector<AvailabilitySource::State> sources = {};
  std::optional<std::size_t> latest_source = {};

  bool is_available() const;
  // The state, unless it has expired.
  Value state_at(Moment now) const;
};

// How the application calls a thing.
struct Spoken {
  std::string device;
  std::string room;
};

// Not thread-safe. Pointers to devices hold until set() or remove().
class DeviceTable {
public:
  // How many things may be announced, and how many may share a topic.
  static constexpr std::size_t max_devices = 2'000;

  // The list must outlive the table.
  explicit DeviceTable(const DeviceList& list);

  // Replaces all things of one discovery message; none: they are gone. False if
  // there are too many. A thing that is announced again keeps its state.
  bool set(const std::string& message, std::vector<Entity> entities);

  // What the application means. Things that the list names by these words come
  // before those whose kind or name fits.
  // Empty: there is none in that room.
  std::vector<Device*> find(const std::string& device, const std::string& room);
  Device* find(const std::string& id);
  // All that read the topic.
  std::vector<Device*> readers(const std::string& topic);
  // Nothing if the application has a list, and it is not on it.
  std::optional<Spoken> spoken(const Device& device) const;
  // What is in a room, in the application's words, each once.
  std::vector<std::string> in_room(const std::string& room) const;

  // The topics that somebody reads.
  // Each once.
  std::vector<std::string> topics() const;
  // Topics that have got their first reader, or lost their last, since the last
  // call.
  struct Changes {
    std::vector<std::string> added;
    std::vector<std::string> removed;
  };
  Changes changes();

  std::size_t size() const {
    return devices_.size();
  }
  // How many of them the application speaks of.
  std::size_t spoken_of() const;

private:
  // With the words by which it may be called, and the rows that mean it.
  Device device_of(Entity entity) const;
  bool means(const ListedDevice& listed, const Device& device) const;
  bool is_listed(const Words& device) const;
  void read(const Device& device);
  void forget(const std::string& id);

  const DeviceList& list_;
  std::map<std::string, Device> devices_; // by the entity's id
  std::map<std::string, std::vector<std::string>> by_message_;
  std::unordered_map<std::string, std::vector<std::string>> by_topic_;
  Changes changes_;
};

} // namespace parlour::adapters::mqtt
