#include <gtest/gtest.h>

#include "adapters/vad/echo_gauge.hpp"

namespace parlour::adapters {
namespace {

// Two seconds in which so much plays and so much is heard.
void pass(EchoGauge& gauge, double played, double heard, int frames = 100) {
  for (int i = 0; i < frames; ++i) {
    gauge.plays(played);
    gauge.hears(heard);
  }
}

TEST(EchoGaugeTest, KnowsOfNoEchoWhileNothingPlays) {
  EchoGauge gauge(10);
  gauge.hears(-20);
  EXPECT_EQ(gauge.played(), lowest_level);
  EXPECT_EQ(gauge.most_of(gauge.played()), lowest_level);
}

TEST(EchoGaugeTest, AssumesAnEchoAtFirst) {
  EchoGauge gauge(10);
  pass(gauge, -20, -60, 1);
  EXPECT_DOUBLE_EQ(gauge.most_of(gauge.played()), -30);
}

TEST(EchoGaugeTest, LearnsThatThereIsNone) {
  EchoGauge gauge(10);
  pass(gauge, -20, -70);
  EXPECT_LT(gauge.most_of(gauge.played()), -60);
  EXPECT_TRUE(gauge.is_silent());
}

TEST(EchoGaugeTest, LearnsHowLoudItIs) {
  EchoGauge gauge(10);
  pass(gauge, -20, -40);
  EXPECT_DOUBLE_EQ(gauge.echo_of(-20), -40);
  EXPECT_GT(gauge.most_of(-20), -40);
  EXPECT_FALSE(gauge.is_silent());
  // A loudspeaker beside the microphone: it takes some seconds.
  pass(gauge, -20, -22, 400);
  EXPECT_DOUBLE_EQ(gauge.echo_of(-20), -22);
}

// Who talks over the robot is no echo, nor is a knock.
TEST(EchoGaugeTest, IsNotMisledByWhoTalksOverIt) {
  EchoGauge gauge(10);
  pass(gauge, -20, -70, 30);
  pass(gauge, -20, -24, 60);
  EXPECT_LT(gauge.most_of(-20), -60);
  gauge.hears(-5);
  pass(gauge, -20, -70, 60);
  EXPECT_LT(gauge.most_of(-20), -60);
}

// What the devices hold back sounds later, and then the room goes on.
TEST(EchoGaugeTest, AnEchoOutlastsWhatPlayed) {
  EchoGauge gauge(10);
  pass(gauge, -20, -60, 5);
  for (int i = 0; i < 10; ++i)
    gauge.hears(-60);
  EXPECT_GT(gauge.played(), -30);
  EXPECT_EQ(gauge.playing(), lowest_level);
  for (int i = 0; i < 20; ++i)
    gauge.hears(-60);
  EXPECT_EQ(gauge.played(), lowest_level);
}

} // namespace
} // namespace parlour::adapters
