// LogDevices (role Devices), a stand-in for what is switched and measured in a
// house: a file of the application (report_table.hpp) says what there is.
//
//   device   room     value  from  to
//   lamp     kitchen  off
//   heating  kitchen  20     5     30
//
//   Set(device, room, value)  State(device, room, value), or Failed(reason)
//   Ask(device, room)         State(device, room, value), or Failed(reason)
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
  using Place = std::pair<std::string, std::string>; // device, room

  void tell(const Place& place, const Value& value);

  ReportTable table_;
  std::map<Place, Value> values_; // what was set
};

PluginFactory log_devices_factory();

} // namespace parlour::adapters
