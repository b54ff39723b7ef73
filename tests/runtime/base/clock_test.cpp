#include <gtest/gtest.h>

#include "runtime/base/clock.hpp"

namespace parlour {
namespace {

using namespace std::chrono_literals;

TEST(SystemClock, GoesOnFromALikelyTime) {
  SystemClock clock;
  auto first = clock.now();
  EXPECT_GT(first, 1'600'000'000'000);
  EXPECT_GE(clock.now(), first);
}

TEST(Timestamp, ReadsBackInLocalTime) {
  auto time = parse_timestamp("2026-11-21 09:00");
  ASSERT_TRUE(time);
  EXPECT_EQ(format_timestamp(*time, "%Y-%m-%d %H:%M"), "2026-11-21 09:00");
  auto seconds = parse_timestamp("2026-11-21 09:00:30");
  ASSERT_TRUE(seconds);
  EXPECT_EQ(*seconds - *time, 30'000);
}

TEST(Timestamp, KnowsLeapDays) {
  EXPECT_TRUE(parse_timestamp("2028-02-29 12:00"));
  EXPECT_FALSE(parse_timestamp("2027-02-29 12:00"));
}

TEST(Timestamp, RefusesWhatIsNoTime) {
  for (auto text : {"", "tomorrow", "2026-11-21", "2026-11-21 9", "09:00",
                    "2026-13-01 09:00", "2026-11-31 09:00", "2026-11-21 25:00",
                    "2026-11-21 09:00 pm"}) {
    auto time = parse_timestamp(text);
    ASSERT_FALSE(time) << text;
    EXPECT_EQ(time.error().kind, ErrorKind::settings);
    EXPECT_NE(time.error().message.find(text), std::string::npos);
  }
}

TEST(FormatTimestamp, TakesAnyPatternOfStrftime) {
  auto time = parse_timestamp("2026-11-21 09:05").value();
  EXPECT_EQ(format_timestamp(time, ""), "");
  EXPECT_EQ(format_timestamp(time, "%H"), "09");
  EXPECT_EQ(format_timestamp(time + 999, "%S"), "00");
  std::string pattern(200, '-');
  EXPECT_EQ(format_timestamp(time, pattern.c_str()), pattern);
}

TEST(FormatTimestamp, RoundsDownBefore1970) {
  EXPECT_EQ(format_timestamp(-1, "%S"), "59");
}

TEST(Duration, HasFourUnits) {
  EXPECT_EQ(parse_duration("200ms").value(), 200ms);
  EXPECT_EQ(parse_duration("1.5s").value(), 1500ms);
  EXPECT_EQ(parse_duration("2m").value(), 2min);
  EXPECT_EQ(parse_duration("1h").value(), 1h);
  EXPECT_EQ(parse_duration("0s").value(), 0ms);
}

TEST(Duration, RefusesWhatIsNone) {
  for (auto text : {"", "5", "s", "ms", "-1s", "1d", "1 hour", "onesecond",
                    "1e300s", "nans", "5xms"}) {
    auto duration = parse_duration(text);
    ASSERT_FALSE(duration) << text;
    EXPECT_EQ(duration.error().kind, ErrorKind::settings);
  }
}

} // namespace
} // namespace parlour
