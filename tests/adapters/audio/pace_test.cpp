#include <gtest/gtest.h>

#include "adapters/audio/pace.hpp"

namespace parlour::adapters {
namespace {

TEST(PaceTest, ReadsItsOption) {
  EXPECT_TRUE(Pace::read("1"));
  EXPECT_TRUE(Pace::read("0"));
  EXPECT_TRUE(Pace::read("0.1"));
  EXPECT_TRUE(Pace::read("16"));
  for (const auto* text : {"17", "-1", "0.01", "fast", "", "nan", "inf"})
    EXPECT_FALSE(Pace::read(text)) << text;
}

TEST(PaceTest, FramesAreDueWhenTheyAreComplete) {
  auto pace = *Pace::read("1");
  pace.begin(1'000);
  EXPECT_EQ(pace.until_next(1'000), Milliseconds(20));
  EXPECT_EQ(pace.until_next(1'020), Milliseconds(0));
  pace.next();
  EXPECT_EQ(pace.until_next(1'021), Milliseconds(19));
}

// Delays are whole milliseconds, yet frames of 1.25 ms stay in time.
TEST(PaceTest, DoesNotDrift) {
  auto pace = *Pace::read("0");
  pace.begin(0);
  Timestamp now = 0;
  for (int i = 0; i < 8'000; ++i, pace.next())
    now += pace.until_next(now).count();
  EXPECT_NEAR(static_cast<double>(now), 10'000, 2);
}

TEST(PaceTest, ALateThreadCatchesUpWithinBounds) {
  auto pace = *Pace::read("1");
  pace.begin(0);
  auto caught_up = [&](Timestamp now) {
    int frames = 0;
    for (; pace.until_next(now) == Milliseconds(0); ++frames)
      pace.next();
    return frames;
  };
  EXPECT_EQ(caught_up(200), 10);
  EXPECT_LE(caught_up(3'600'000), Pace::most_late + 1);
}

TEST(PaceTest, MoreSoundPassesWhenItIsFaster) {
  EXPECT_EQ(Pace::read("10")->sound_in(Milliseconds(5)), Milliseconds(50));
}

} // namespace
} // namespace parlour::adapters
