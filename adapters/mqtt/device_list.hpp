// DeviceList is the application's own list of devices, the file that LogDevices
// reads too (adapters/standins). Here it tells by which words the application
// calls what announces itself:
//
//  device       room     value  from  to  kind
//  lamp         *        off              light
//  heating      kitchen  20     5     30  climate
//  thermometer  *        21               sensor:temperature
//
// Behind the colon stands the device class, or a word of the name. `*` stands
// for every room. `from` and `to` narrow what may be set. Further columns may
// have the names of discovery's fields (state_topic, command_topic, payload_on
// …): such a row is a device of its own, which need not announce itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adapters/mqtt/discovery/discovery.hpp"
#include "adapters/mqtt/discovery/entity.hpp"
#include "adapters/mqtt/spoken_names.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::mqtt {

// One row. The three lists of words are the texts as they are compared.
struct ListedDevice {
  std::string device;
  std::string room; // "*": every room
  std::string kind;
  std::string device_class; // empty: any
  std::optional<double> from;
  std::optional<double> to;

  Words device_words = {};
  Words room_words = {};
  Words class_words = {};
};

struct DeviceList {
  std::vector<ListedDevice> devices;
  // Those of the rows that have topics.
  std::vector<Entity> entities;

  // The error, of kind File or Settings, names the file and what is wrong.
  static Expected<DeviceList> read(const std::filesystem::path& file);
};

} // namespace parlour::adapters::mqtt
