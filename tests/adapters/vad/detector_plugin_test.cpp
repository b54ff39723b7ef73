#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/vad/adaptive_vad.hpp"
#include "adapters/vad/detector_plugin.hpp"
#include "tests/support/audio/sounds.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// AdaptiveVAD stands for the plug-ins of all detectors.
class DetectorPluginTest : public testing::Test {
protected:
  void start() {
    plugin = adaptive_vad_factory().create();
    ASSERT_TRUE(plugin->start(host, {}));
  }
  void hear(const test::Sound& sound, const SessionId& session = "s1") {
    plugin->receive(test::message("Process", {pcm_value(sound)}, session));
  }
  double position(std::size_t event) const {
    return host.events.at(event).params.at(0).number_or(-1);
  }

  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
  test::Sound speech = test::speech_like(1, 1'200, -20);
};

TEST_F(DetectorPluginTest, TellsWhereSpeechIs) {
  start();
  hear(test::silence(2'000));
  EXPECT_THAT(host.events, IsEmpty());
  hear(speech);
  hear(test::silence(1'000));
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_EQ(host.events[0].command, "SpeechStarted");
  EXPECT_NEAR(position(0), 2'000, 200);
  EXPECT_EQ(host.events[1].command, "SpeechEnded");
  EXPECT_NEAR(position(1), 2'000 + static_cast<double>(duration(speech.size())),
              300);
}

TEST_F(DetectorPluginTest, KeepsSessionsApart) {
  start();
  hear(test::silence(1'000), "one");
  hear(speech, "two");
  hear(test::silence(1'000), "one");
  EXPECT_FALSE(host.events.empty());
  for (const auto& event : host.events)
    EXPECT_EQ(event.session, "two");
}

TEST_F(DetectorPluginTest, BeginsAnew) {
  start();
  hear(test::silence(4'000));
  plugin->receive(test::message("Reset"));
  hear(test::silence(1'000));
  hear(speech);
  ASSERT_FALSE(host.events.empty());
  EXPECT_NEAR(position(0), 1'000, 200);
}

TEST_F(DetectorPluginTest, RefusesWhatIsNoAudio) {
  start();
  plugin->receive(
      test::message("Process", {Binary{"pcm_s16le;rate=8000;channels=1", {}}}));
  EXPECT_THAT(host.take_events(), ElementsAre(HasSubstr("16,000 samples")));
}

} // namespace
} // namespace parlour::adapters
