#include <gtest/gtest.h>

#include "adapters/vad/level.hpp"
#include "tests/support/audio/sounds.hpp"

namespace parlour::adapters {
namespace {

TEST(LevelTest, IsThatOfTheSoundWithoutItsLowestPart) {
  EXPECT_NEAR(LevelMeter().level(test::tone(1'000, 1'000, -20)), -20, 1.5);
  EXPECT_LT(LevelMeter().level(test::tone(50, 1'000, -20)), -33);
  EXPECT_EQ(LevelMeter().level(test::silence(20)), lowest_level);
  EXPECT_EQ(LevelMeter().level({}), lowest_level);
}

} // namespace
} // namespace parlour::adapters
