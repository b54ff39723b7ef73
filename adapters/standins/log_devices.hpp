// LogDevices (role Devices) is a stand-in for the devices and sensors of a
// building. A file of the application lists them (report_table.hpp):
//
//  device   room     value  from  to
//  lamp     kitchen  off
//  heating  kitchen  20     5     30
//
//  Set(device, room, value)  State(device, room, value), or Failed(reason)
//  Ask(device, room)         State(device, room, value), or Failed(reason)
#pragma once

#include <map>
#include <string>
#include <utility>

#include "adapters/standins/report_table.hpp"
#include "adapters/standins/stand_in.hpp"

namespace parlour::adapters {

class LogDevices : public StandIn {
public:
  LogDevices() : StandIn("devices") {}

protected:
  Expected<void> on_options(const Options& options) override;
  bool carry_out(const Message& message) override;

private:
  // Device and room.
  using DeviceKey = std::pair<std::string, std::string>;

  void tell(const DeviceKey& key, const Value& value);

  ReportTable table_;
  // The values that were set; all others are those of the table.
  std::map<DeviceKey, Value> values_;
};

PluginFactory log_devices_factory();

} // namespace parlour::adapters
