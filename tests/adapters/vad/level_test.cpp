#include <gtest/gtest.h>

#include "adapters/vad/level.hpp"
#include "tests/support/audio/sounds.hpp"

namespace parlour::adapters {
namespace {

TEST(LevelTest, IsThatOfTheSoundWithoutItsLowestPart) {
  EXPECT_NEAR(SpeechBandMeter().level(test::tone(1'000, 1'000, -20)), -20, 1.5);
  EXPECT_LT(SpeechBandMeter().level(test::tone(50, 1'000, -20)), -33);
  EXPECT_EQ(SpeechBandMeter().level(test::silence(20)), lowest_level);
  EXPECT_EQ(SpeechBandMeter().level({}), lowest_level);
}

} // namespace
} // namespace parlour::adapters
