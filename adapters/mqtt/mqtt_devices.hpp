// The plug-in MQTTDevices (role Devices): lights, heatings, locks and sensors
// that an MQTT server connects, and that announce themselves as Home Assistant
// expects it (docs/devices.md). It answers scripts as LogDevices does:
//
//  Set(device, room, value)  State(device, room, value) once the device shows
//                            that it has obeyed, or Failed(reason)
//  Ask(device, room)         State(device, room, value), or Failed(reason)
//
// What changes by itself is told by the event State.
//
// Threads: a loop of its own drives the connection; answers and events come
// from there. The thread that calls the plug-in never waits, except with the
// option `one-by-one`, which virtual time needs.
#pragma once

#include <memory>

#include "adapters/mqtt/mqtt_options.hpp"
#include "runtime/plugin/open_messages.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters::mqtt {

// `open_` counts the messages that are not answered yet.
class MQTTDevices : public IPlugin {
public:
  MQTTDevices();
  ~MQTTDevices() override;

  void stop() override;

protected:
  // A server that cannot be reached is no error: the component tries again, and
  // is not available until it succeeds.
  Expected<void> on_start(const Options& options) override;
  void on_message(const Message& message) override;

private:
  class House;

  // Called on the loop's thread.
  void tell(const Message& to, const std::string& command,
            std::vector<Value> params);

  MQTTOptions options_;
  OpenMessages open_;
  // The last member: it still answers messages while it is destroyed.
  std::unique_ptr<House> house_;
};

} // namespace parlour::adapters::mqtt

namespace parlour::adapters {

PluginFactory mqtt_devices_factory();

} // namespace parlour::adapters
