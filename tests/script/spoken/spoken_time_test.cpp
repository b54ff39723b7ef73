#include <gtest/gtest.h>

#include "script/spoken/spoken_time.hpp"

namespace parlour::script {

namespace {

std::string on(const char* now, const char* day) {
  return spoken_date(day, *parse_timestamp(std::string(now) + " 09:00"));
}

TEST(SpokenTime, DatesNearHaveTheirWeekday) {
  EXPECT_EQ(on("2026-06-01", "2026-11-30"), "Monday, 30 November");
  EXPECT_EQ(on("2026-06-01", "2026-12-15"), "15 December twenty twenty six");
  EXPECT_EQ(on("2026-12-30", "2027-01-05"),
            "Tuesday, 5 January twenty twenty seven");
  EXPECT_EQ(on("2026-12-30", "2026-12-01"), "Tuesday, 1 December");
  EXPECT_EQ(on("2042-01-01", "2038-05-03"), "3 May twenty thirty eight");
}

TEST(SpokenTime, DurationsHaveTheirUnits) {
  const auto said = [](double seconds) {
    return spoken_duration(decimal_of(seconds));
  };
  EXPECT_EQ(said(59.5), "fifty nine point five seconds");
  EXPECT_EQ(said(60.4), "one minute");
  EXPECT_EQ(said(7200), "two hours");
  EXPECT_EQ(said(172'860), "two days and one minute");
  EXPECT_EQ(said(-5), "minus five");
}

} // namespace

} // namespace parlour::script
