// What tests of the plug-ins share: a host, and a plug-in that uses a server.
#pragma once

#include <cmath>

#include "runtime/plugin/conformance.hpp"
#include "tests/adapters/tts/tts_fixture.hpp"
#include "tests/adapters/wyoming/wyoming_server.hpp"

namespace parlour::test {

class WyomingTest : public TtsTest {
protected:
  using Peer = WyomingServer::Peer;
  using Event = adapters::wyoming::Event;

  // Waits until the plug-in has found the server.
  void connect(const PluginFactory& factory, Options options) {
    ASSERT_TRUE(start(factory, options));
    EXPECT_TRUE(host.wait([&] { return said("connected"); }, patience));
    EXPECT_TRUE(host.wait([&] { return host.is_available(); }, patience));
  }
  bool said(const std::string& text) {
    for (const auto& log : host.take_logs())
      if (log.find(text) != std::string::npos)
        return true;
    return false;
  }
  bool says(const std::string& text) {
    return host.wait([&] { return said(text); }, patience);
  }
  static Value frame() {
    return adapters::pcm_value(
        std::vector<adapters::Sample>(adapters::frame_samples, 100));
  }
  // The parameters of the first event of this command.
  std::vector<Value> answer(const std::string& command) {
    return events_until(command).back().params;
  }
};

} // namespace parlour::test
