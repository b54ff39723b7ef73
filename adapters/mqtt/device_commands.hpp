// What is published when an application sets a device to a value.
#pragma once

#include <string>
#include <vector>

#include "adapters/mqtt/device_table.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::mqtt {

// "Set the blind to open" publishes OPEN; the state "opening" shows already
// that it obeys.
struct DeviceCommand {
  std::string topic;
  std::string payload;
  // The states that show that it is carried out.
  std::vector<Value> shown_by;
};

// The error, of kind Refused, is a sentence for the user; `spoken` is how the
// application calls the device.
Expected<DeviceCommand> command_for(const Device& device, const Spoken& spoken,
                                    const Value& value);

// Whether the state is one of those; numbers may differ by rounding.
bool shows(const Value& state, const std::vector<Value>& wanted);

// "The lamp in the kitchen"
std::string subject(const Spoken& spoken);

} // namespace parlour::adapters::mqtt
