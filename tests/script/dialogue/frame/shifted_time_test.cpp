#include <gtest/gtest.h>

#include "script/dialogue/frame/shifted_time.hpp"

namespace parlour::dialogue {

namespace {

TEST(ShiftedTime, MovesATimeWithinTheDay) {
  EXPECT_EQ(shifted_time("06:30", "+01:00"), Value("07:30"));
  EXPECT_EQ(shifted_time("15:00", "-00:30"), Value("14:30"));
  EXPECT_EQ(shifted_time("23:15", "+00:44"), Value("23:59"));
  EXPECT_EQ(shifted_time("00:30", "-00:30"), Value("00:00"));
}

TEST(ShiftedTime, ChangesNoDate) {
  EXPECT_TRUE(shifted_time("23:45", "+00:30").is_unknown());
  EXPECT_TRUE(shifted_time("00:15", "-00:30").is_unknown());
}

TEST(ShiftedTime, NeedsATimeAndADifference) {
  EXPECT_TRUE(shifted_time({}, "+01:00").is_unknown());
  EXPECT_TRUE(shifted_time("soon", "+01:00").is_unknown());
  EXPECT_TRUE(shifted_time("06:30", "07:30").is_unknown());
  EXPECT_TRUE(shifted_time("06:30", {}).is_unknown());
  EXPECT_TRUE(shifted_time(6, "+01:00").is_unknown());
}

} // namespace

} // namespace parlour::dialogue
