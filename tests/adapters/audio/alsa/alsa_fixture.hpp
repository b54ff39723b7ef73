// What tests of the plug-ins for ALSA share: a plug-in, a device of our own,
// and what the plug-in says.
#pragma once

#include <algorithm>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/test_host.hpp"
#include "tests/adapters/audio/alsa/virtual_device.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::test {

class AlsaTest : public testing::Test {
protected:
  static constexpr Milliseconds patience{20'000};

  void use(const VirtualDeviceOptions& options) {
    device.emplace(options);
  }
  Expected<void> start(const PluginFactory& factory, const std::string& name) {
    if (!device)
      device.emplace();
    plugin = factory.create();
    return plugin->start(host, {{"device", name}});
  }
  void send(std::string command, std::vector<Value> params = {}) {
    plugin->receive(message(std::move(command), std::move(params)));
  }

  // Whether the event has audio, which is kept then.
  virtual bool take_audio(const Message& event) = 0;
  // Takes what has come: audio, other events to `events`.
  void take() {
    for (auto& event : host.take_events())
      if (!take_audio(event))
        events.push_back(to_string(event).substr(1));
  }
  bool gets(const std::string& event) {
    return host.wait(
        [&] {
          take();
          return std::ranges::any_of(events, [&](const std::string& one) {
            return one.starts_with(event);
          });
        },
        patience);
  }
  // Until the device blocks, or has been closed after that.
  void wait_until_gone(bool gone) {
    while (device->is_gone() != gone)
      host.wait([] { return false; }, Milliseconds(5));
  }

  // The samples of one frame.
  static std::vector<adapters::Sample> frame_of(const Value& audio) {
    const auto samples = *adapters::speech_samples(audio);
    EXPECT_EQ(samples.size(), adapters::frame_samples);
    return {samples.begin(), samples.end()};
  }

  TestHost host;
  std::optional<VirtualDevice> device;
  std::unique_ptr<IPlugin> plugin;
  std::vector<std::string> events;
};

} // namespace parlour::test
