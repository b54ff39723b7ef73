#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/pcm.hpp"
#include "adapters/endpointer/key_endpointer.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class KeyEndpointerTest : public testing::Test {
protected:
  Expected<void> start(const Options& options = {}) {
    plugin = key_endpointer_factory().create();
    return plugin->start(host, options);
  }
  void send(std::string command, std::vector<Value> params = {}) {
    plugin->receive(test::message(std::move(command), std::move(params)));
  }
  void hear(int frames) {
    const std::vector<Sample> samples(frame_samples);
    for (int i = 0; i < frames; ++i)
      send("Process", {pcm_value(samples)});
  }
  // From this position on.
  void hear(int frames, std::int64_t position) {
    const std::vector<Sample> samples(frame_samples);
    for (int i = 0; i < frames; ++i)
      send("Process", {pcm_value(samples), position + 20 * i});
  }

  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
};

TEST_F(KeyEndpointerTest, Conforms) {
  EXPECT_THAT(conformance_errors(key_endpointer_factory(), {}), IsEmpty());
}

TEST_F(KeyEndpointerTest, PassesATurnOn) {
  ASSERT_TRUE(start({{"before", "100ms"}, {"after", "60ms"}}));
  hear(50); // a second
  send("Pressed");
  hear(50);
  send("Released");
  hear(50);
  const auto events = host.take_events();
  ASSERT_GT(events.size(), 2u);
  EXPECT_EQ(events.front(), "TurnStarted(980)");
  EXPECT_EQ(events.back(), "TurnEnded(1980, 80)");
  EXPECT_EQ(events.size() - 2, 59u); // from 880 to 2,040 ms
}

// A microphone that was started again counts from 0.
TEST_F(KeyEndpointerTest, ForgetsAStreamThatHasEnded) {
  ASSERT_TRUE(start());
  hear(500, 0);
  hear(500, 0);
  send("Pressed");
  const auto events = host.take_events();
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.front(), "TurnStarted(9980)");
  EXPECT_EQ(events.size() - 1, 16u); // of the last 300 ms
  hear(10, 0);
  EXPECT_THAT(host.take_events(), ElementsAre("TurnDropped(9980)"));
}

TEST_F(KeyEndpointerTest, EndsATurnInWhichNoAudioComes) {
  ASSERT_TRUE(start());
  send("Pressed");
  host.advance(Milliseconds(900));
  EXPECT_THAT(host.take_events(), ElementsAre("TurnStarted(0)"));
  host.advance(Milliseconds(1'100));
  EXPECT_THAT(host.take_events(), ElementsAre("TurnDropped(0)"));
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(KeyEndpointerTest, TakesNobodyElsesWord) {
  ASSERT_TRUE(start());
  hear(1);
  send("SpeechStarted", {0});
  send("Partial", {"hello", 1, true});
  send("RobotStarted", {1});
  hear(10);
  send("RobotFinished", {1});
  send("SpeechEnded", {100});
  hear(100);
  EXPECT_THAT(host.take_events(), IsEmpty());
}

TEST_F(KeyEndpointerTest, RefusesTimesThatKeepTooMuch) {
  EXPECT_FALSE(start({{"longest", "10m"}}));
  EXPECT_FALSE(start({{"longest", "10ms"}}));
  EXPECT_FALSE(start({{"before", "11s"}}));
  EXPECT_TRUE(start({{"after", "1s"}, {"longest", "10s"}}));
}

} // namespace
} // namespace parlour::adapters
