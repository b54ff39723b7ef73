#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/pcm.hpp"
#include "adapters/enhancement/echo_canceller.hpp"
#include "adapters/enhancement/enhancement.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/support/audio/sounds.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class EnhancementTest : public testing::Test {
protected:
  void SetUp() override {
    if (!EchoCanceller::make({}))
      GTEST_SKIP() << "built without libwebrtc-audio-processing";
  }
};

TEST_F(EnhancementTest, ChangesNothingWhileNothingPlays) {
  test::FakePluginHost host;
  const auto plugin = webrtc_enhancement_factory().create();
  ASSERT_TRUE(plugin->start(host, {}));
  const auto sound = pcm_value(test::speech_like(4, 20, -20));
  plugin->receive(test::message("Process", {sound, 1'000}));
  plugin->receive(test::message("Process", {sound}));
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_THAT(host.events[0].params, ElementsAre(sound, Value(1'000)));
  EXPECT_THAT(host.events[1].params, ElementsAre(sound, Value(1'020)));
}

TEST_F(EnhancementTest, PassesOnWhatItCannotEnhance) {
  test::FakePluginHost host;
  const auto plugin = webrtc_enhancement_factory().create();
  ASSERT_TRUE(plugin->start(host, {}));
  const Value other = Binary{"pcm_s16le;rate=8000;channels=1", {}};
  plugin->receive(test::message("Process", {other, 40}));
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_THAT(host.events[0].params, ElementsAre(other, Value(40)));
  EXPECT_FALSE(
      webrtc_enhancement_factory().create()->start(host, {{"delay", "2s"}}));
}

TEST_F(EnhancementTest, Conforms) {
  EXPECT_THAT(conformance_errors(webrtc_enhancement_factory(), {}), IsEmpty());
}

} // namespace
} // namespace parlour::adapters
