// What tests of voices share: a started plug-in and what it says.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/pcm.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::test {

class TtsTest : public testing::Test {
protected:
  // Generous: machines are busy, and only a test that fails takes so long.
  static constexpr Milliseconds patience{60'000};

  ~TtsTest() override {
    if (plugin)
      plugin->stop();
  }

  Expected<void> start(const PluginFactory& factory,
                       const Options& options = {}) {
    plugin = factory.create();
    return plugin->start(host, options);
  }
  void send(std::string command, std::vector<Value> params = {},
            SessionId session = "s1") {
    plugin->receive(
        message(std::move(command), std::move(params), std::move(session)));
  }

  // All events up to `count` of this command; the time goes on as needed.
  std::vector<Message> events_until(const std::string& command,
                                    std::size_t count = 1) {
    std::vector<Message> all;
    std::size_t seen = 0;
    EXPECT_TRUE(host.wait(
        [&] {
          for (auto& event : host.take_events()) {
            seen += event.command == command;
            all.push_back(std::move(event));
          }
          return seen >= count;
        },
        patience));
    return all;
  }

  static std::vector<Message> only(const std::vector<Message>& events,
                                   const std::string& command) {
    std::vector<Message> found;
    for (const auto& event : events)
      if (event.command == command)
        found.push_back(event);
    return found;
  }

  // "word@position" of each mark.
  static std::vector<std::string> marks(const std::vector<Message>& events) {
    std::vector<std::string> found;
    for (const auto& event : only(events, "Mark"))
      found.push_back(event.params.at(1).text() + '@' +
                      event.params.at(2).text());
    return found;
  }
  static std::vector<std::string>
  marked_words(const std::vector<Message>& events) {
    std::vector<std::string> found;
    for (const auto& event : only(events, "Mark"))
      found.push_back(event.params.at(1).text());
    return found;
  }

  // All samples; each event must be one frame.
  static std::vector<adapters::Sample>
  sound(const std::vector<Message>& events) {
    std::vector<adapters::Sample> all;
    for (const auto& event : only(events, "Audio")) {
      const auto samples = adapters::speech_samples(event.params.at(0));
      EXPECT_TRUE(samples);
      EXPECT_EQ(samples->size(), adapters::frame_samples);
      all.insert(all.end(), samples->begin(), samples->end());
    }
    return all;
  }

  TestHost host;
  std::unique_ptr<IPlugin> plugin;
};

} // namespace parlour::test
