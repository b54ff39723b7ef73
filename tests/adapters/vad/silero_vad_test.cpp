// SileroVAD with a program that speaks its protocol; with the network itself in
// detectors_test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/pcm.hpp"
#include "adapters/vad/silero_vad.hpp"
#include "runtime/plugin/conformance.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/adapters/asr/fake_moonshine.hpp"
#include "tests/support/audio/sounds.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr Milliseconds patience{60'000};

class SileroVadTest : public testing::Test {
protected:
  ~SileroVadTest() override {
    if (plugin)
      plugin->stop();
  }

  Expected<void> start(const std::string& mode, Options more = {}) {
    fake.emplace(mode);
    more.emplace("node", test::FakeMoonshine::interpreter());
    plugin = silero_vad_factory({fake->program()}).create();
    return plugin->start(host, more);
  }
  void send(const std::string& command, std::vector<Value> params,
            const SessionId& session) {
    Message message;
    message.session = session;
    message.command = command;
    message.params = std::move(params);
    plugin->receive(message);
  }
  // In frames of 20 ms, from this position on.
  void hear(const test::Sound& sound, std::int64_t position,
            const SessionId& session = "one") {
    for (std::span<const Sample> rest = sound; !rest.empty();) {
      const auto count = std::min(rest.size(), frame_samples);
      send("Process", {pcm_value(rest.first(count)), position}, session);
      position += duration(count);
      rest = rest.subspan(count);
    }
  }
  // So many events, each as "session: Name position".
  std::vector<std::string> events(std::size_t count) {
    std::vector<std::string> found;
    host.wait(
        [&] {
          for (const auto& event : host.take_events())
            found.push_back(event.session + ": " + event.command + " " +
                            event.params.at(0).text());
          return found.size() >= count;
        },
        patience);
    return found;
  }

  TestHost host;
  std::optional<test::FakeMoonshine> fake;
  std::unique_ptr<IPlugin> plugin;
};

TEST_F(SileroVadTest, Conforms) {
  fake.emplace("works");
  TestOptions terms;
  terms.options = {{"node", test::FakeMoonshine::interpreter()}};
  EXPECT_THAT(conformance_errors(silero_vad_factory({fake->program()}), terms),
              testing::IsEmpty());
}

TEST_F(SileroVadTest, RefusesWrongOptions) {
  EXPECT_FALSE(start("works", {{"hangover", "1h"}}));
  EXPECT_FALSE(start("works", {{"echo-loss", "loud"}}));
  const auto missing = start("works", {{"program", "nowhere.mjs"}});
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("AdaptiveVAD needs none"));
}

TEST_F(SileroVadTest, TellsWhereSpeechIsInEachSession) {
  ASSERT_TRUE(start("works", {{"one-by-one", "true"}}));
  hear(test::silence(320), 0);
  hear(test::tone(300, 640, -20), 320);
  hear(test::tone(300, 320, -20), 0, "two");
  hear(test::silence(640), 960);
  EXPECT_THAT(events(3),
              ElementsAre("one: SpeechStarted 320", "two: SpeechStarted 0",
                          "one: SpeechEnded 960"));
}

TEST_F(SileroVadTest, SpeechEndsAtAGap) {
  ASSERT_TRUE(start("works", {{"one-by-one", "true"}}));
  hear(test::tone(300, 640, -20), 0);
  hear(test::silence(320), 5'000);
  EXPECT_THAT(events(2),
              ElementsAre("one: SpeechStarted 0", "one: SpeechEnded 640"));
}

TEST_F(SileroVadTest, FailsWithItsProgram) {
  ASSERT_TRUE(start("dies", {{"one-by-one", "true"}}));
  hear(test::tone(300, 640, -20), 0);
  std::vector<std::string> failures;
  host.wait(
      [&] {
        failures = host.take_failures();
        return !failures.empty();
      },
      patience);
  EXPECT_THAT(failures, ElementsAre(HasSubstr("ended with status 4")));
}

} // namespace
} // namespace parlour::adapters
