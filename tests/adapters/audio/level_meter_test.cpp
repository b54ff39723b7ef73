#include <gtest/gtest.h>

#include "adapters/audio/level_meter.hpp"
#include "tests/adapters/audio/tones.hpp"

namespace parlour::adapters {
namespace {

TEST(LevelMeterTest, SilenceIsAtTheFloor) {
  LevelMeter meter;
  EXPECT_EQ(meter.level(), LevelMeter::floor);
  meter.add(std::vector<Sample>(1'600));
  EXPECT_EQ(meter.level(), LevelMeter::floor);
  EXPECT_EQ(meter.peak(), LevelMeter::floor);
  EXPECT_EQ(meter.clipped(), 0);
  EXPECT_EQ(meter.samples(), 1'600u);
}

TEST(LevelMeterTest, ATone) {
  LevelMeter meter;
  meter.add(test::tone(400, 0.1, 16'000));
  EXPECT_NEAR(meter.level(), -23, 0.05);
  EXPECT_NEAR(meter.peak(), -20, 0.05);
  EXPECT_EQ(meter.clipped(), 0);
  meter.reset();
  EXPECT_EQ(meter.samples(), 0u);
  EXPECT_EQ(meter.level(), LevelMeter::floor);
}

TEST(LevelMeterTest, AnOffsetIsNoSound) {
  LevelMeter meter;
  meter.add(std::vector<Sample>(1'600, 1'000));
  EXPECT_EQ(meter.level(), LevelMeter::floor);
}

TEST(LevelMeterTest, WhatIsCutOffIsCounted) {
  LevelMeter meter;
  meter.add(std::vector<Sample>{32'767, -32'768, -32'767, 32'766});
  EXPECT_EQ(meter.clipped(), 0.75);
  EXPECT_NEAR(meter.peak(), 0, 0.001);
}

} // namespace
} // namespace parlour::adapters
