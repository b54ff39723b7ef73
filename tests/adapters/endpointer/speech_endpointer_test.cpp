#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/pcm.hpp"
#include "adapters/endpointer/speech_endpointer.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class SpeechEndpointerTest : public testing::Test {
protected:
  Expected<void> start(const Options& options = {}) {
    plugin = speech_endpointer_factory().create();
    return plugin->start(host, options);
  }
  void send(std::string command, std::vector<Value> params = {}) {
    plugin->receive(test::message(std::move(command), std::move(params)));
  }
  // Silence or not, the detector decides.
  void hear(int frames) {
    const std::vector<Sample> samples(frame_samples);
    for (int i = 0; i < frames; ++i)
      send("Process", {pcm_value(samples)});
  }
  std::vector<std::string> turns() {
    auto events = host.take_events();
    std::erase_if(events, [](const std::string& event) {
      return event.starts_with("Speech(");
    });
    return events;
  }

  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
};

TEST_F(SpeechEndpointerTest, Conforms) {
  EXPECT_THAT(conformance_errors(speech_endpointer_factory(), {}), IsEmpty());
}

TEST_F(SpeechEndpointerTest, PassesATurnOn) {
  ASSERT_TRUE(start());
  hear(50); // a second
  send("SpeechStarted", {1'000});
  hear(50);
  send("SpeechEnded", {2'000});
  send("Partial", {"hello", 1, true});
  hear(50);
  const auto events = host.take_events();
  ASSERT_GT(events.size(), 2u);
  EXPECT_EQ(events.front(), "TurnStarted(1000)");
  EXPECT_EQ(events.back(), "TurnEnded(2000, 320)");
  // From 700 to 2,300 ms.
  EXPECT_EQ(events.size() - 2, 81u);
  EXPECT_THAT(events[1], StartsWith("Speech("));
}

TEST_F(SpeechEndpointerTest, ListensToTheRobot) {
  ASSERT_TRUE(start());
  send("RobotStarted", {1});
  send("RobotStarted", {2});
  send("RobotFinished", {1});
  send("SpeechStarted", {0});
  hear(6);
  send("SpeechEnded", {100});
  hear(10);
  EXPECT_THAT(host.take_events(), IsEmpty());
  send("RobotFinished", {2});
  hear(1);
  EXPECT_THAT(turns(), ElementsAre("TurnStarted(0)"));
}

// A microphone that is unplugged leaves no turn open.
TEST_F(SpeechEndpointerTest, EndsATurnWhenNoAudioComes) {
  ASSERT_TRUE(start());
  hear(2);
  send("SpeechStarted", {0});
  hear(2);
  host.advance(Milliseconds(900));
  hear(2);
  host.advance(Milliseconds(1'000)); // heard since
  EXPECT_THAT(turns(), ElementsAre("TurnStarted(0)"));
  host.advance(Milliseconds(1'000));
  EXPECT_THAT(turns(), ElementsAre("TurnEnded(100, 20)"));
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(SpeechEndpointerTest, StartsAnewAfterReset) {
  ASSERT_TRUE(start());
  send("SpeechStarted", {0});
  hear(2);
  send("Reset");
  EXPECT_THAT(turns(), ElementsAre("TurnStarted(0)", "TurnDropped(20)"));
  send("SpeechStarted", {0});
  hear(1);
  EXPECT_THAT(turns(), ElementsAre("TurnStarted(0)"));
}

TEST_F(SpeechEndpointerTest, SleepsUntilItIsWoken) {
  ASSERT_TRUE(start({{"sleeps-after", "2s"}}));
  send("SpeechStarted", {0});
  hear(50);
  EXPECT_THAT(host.take_events(), IsEmpty());
  send("Wake", {500});
  hear(1);
  EXPECT_THAT(turns(), ElementsAre("Woken(1000)", "TurnStarted(500)"));
  send("SpeechEnded", {1'500});
  hear(200);
  EXPECT_THAT(turns(), ElementsAre("TurnEnded(1500, 720)", "FellAsleep(4200)"));
  send("Wake");
  hear(1);
  send("Sleep");
  hear(1);
  EXPECT_THAT(turns(), ElementsAre("Woken(5020)", "FellAsleep(5040)"));
}

TEST_F(SpeechEndpointerTest, RefusesWhatIsNoSpeech) {
  ASSERT_TRUE(start());
  send("Process", {Binary{"opus", {}}});
  EXPECT_THAT(host.take_events(), Contains(HasSubstr("Failed")));
}

TEST_F(SpeechEndpointerTest, RefusesTimesThatKeepTooMuch) {
  EXPECT_FALSE(start({{"longest", "10m"}}));
  EXPECT_FALSE(start({{"longest", "10ms"}}));
  EXPECT_FALSE(start({{"margin", "11s"}}));
  EXPECT_FALSE(start({{"sleeps-after", "10ms"}}));
  EXPECT_TRUE(start({{"pause", "1s"}, {"longest", "10s"}}));
}

} // namespace
} // namespace parlour::adapters
