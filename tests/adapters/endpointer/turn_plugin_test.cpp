// The rest of what it does is tried with the plug-ins that derive from it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/pcm.hpp"
#include "adapters/endpointer/turn_plugin.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A turn begins with the first frame.
class AllIsTurn : public TurnPlugin {
protected:
  TurnSteps hear(Value, std::int64_t position) override {
    last_ = position;
    if (std::exchange(in_turn_, true))
      return {};
    return {TurnStarted{position}};
  }
  TurnSteps finish() override {
    in_turn_ = false;
    return {TurnEnded{last_}};
  }
  TurnSteps reset() override {
    in_turn_ = false;
    return {TurnDropped{last_}};
  }
  bool in_turn() const override {
    return in_turn_;
  }

private:
  bool in_turn_ = false;
  std::int64_t last_ = 0;
};

class TurnPluginTest : public testing::Test {
protected:
  TurnPluginTest() {
    EXPECT_TRUE(plugin.start(host, {}));
  }
  void hear(std::vector<Value> more = {}) {
    const std::vector<Sample> samples(frame_samples);
    std::vector<Value> params{pcm_value(samples)};
    params.insert(params.end(), more.begin(), more.end());
    plugin.receive(test::message("Process", params));
  }

  test::FakePluginHost host;
  AllIsTurn plugin;
};

TEST_F(TurnPluginTest, CountsPositions) {
  hear({500});
  hear();
  host.advance(Milliseconds(2'000));
  EXPECT_THAT(host.take_events(),
              ElementsAre("TurnStarted(500)", "TurnEnded(520, 20)"));
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(TurnPluginTest, WaitsWhileAudioComes) {
  hear();
  host.advance(Milliseconds(900));
  hear();
  host.advance(Milliseconds(1'000));
  EXPECT_THAT(host.take_events(), ElementsAre("TurnStarted(0)"));
  host.advance(Milliseconds(1'000));
  EXPECT_THAT(host.take_events(), ElementsAre("TurnEnded(20, 20)"));
}

TEST_F(TurnPluginTest, CountsAnewAfterReset) {
  hear({500});
  plugin.receive(test::message("Reset", {}));
  hear();
  EXPECT_THAT(
      host.take_events(),
      ElementsAre("TurnStarted(500)", "TurnDropped(500)", "TurnStarted(0)"));
}

TEST_F(TurnPluginTest, CountsAnewWithAnotherStream) {
  hear({500});
  hear({500}); // a frame again is no other stream
  hear({0});
  EXPECT_THAT(
      host.take_events(),
      ElementsAre("TurnStarted(500)", "TurnDropped(500)", "TurnStarted(0)"));
}

TEST_F(TurnPluginTest, RefusesWhatIsNoSpeech) {
  plugin.receive(test::message("Process", {Binary{"opus", {}}}));
  EXPECT_THAT(host.take_events(), ElementsAre(HasSubstr("Failed")));
}

} // namespace
} // namespace parlour::adapters
