#include <gtest/gtest.h>

#include "runtime/text/shifted_time.hpp"

namespace parlour {

namespace {

TEST(ClockText, WrapsBeyondADay) {
  EXPECT_EQ(clock_text(15 * 60 + 30), "15:30");
  EXPECT_EQ(clock_text(24 * 60 + 5), "00:05");
  EXPECT_EQ(clock_text(-15), "23:45");
}

TEST(ShiftedTime, MovesATimeWithinTheDay) {
  EXPECT_EQ(shifted_time("06:30", "+01:00"), Value("07:30"));
  EXPECT_EQ(shifted_time("15:00", "-00:30"), Value("14:30"));
  EXPECT_EQ(shifted_time("23:15", "+00:44"), Value("23:59"));
  EXPECT_EQ(shifted_time("00:30", "-00:30"), Value("00:00"));
}

TEST(ShiftedTime, ChangesTheMinutesOfTheHourThatIsSaid) {
  EXPECT_EQ(shifted_time("10:15", "past 00:30"), Value("10:30"));
  EXPECT_EQ(shifted_time("06:00", "past 00:30"), Value("06:30"));
  EXPECT_EQ(shifted_time("09:45", "past 00:15"), Value("10:15")); // to ten
  EXPECT_EQ(shifted_time("10:15", "to 00:15"), Value("09:45"));
  EXPECT_TRUE(shifted_time("00:10", "to 00:15").is_unknown());
  EXPECT_TRUE(shifted_time("23:45", "past 00:30").is_unknown());
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

} // namespace parlour
