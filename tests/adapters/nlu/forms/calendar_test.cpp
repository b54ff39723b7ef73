#include <gtest/gtest.h>

#include "adapters/nlu/forms/calendar.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(Calendar, KnowsWhichDaysThereAre) {
  EXPECT_EQ(date_text(*make_day(2028, 2, 29)), "2028-02-29");
  EXPECT_FALSE(make_day(2027, 2, 29));
  EXPECT_FALSE(make_day(1800, 1, 1));
  for (const auto month : {13LL, 257LL, 258LL, 4294967297LL})
    EXPECT_FALSE(make_day(2027, month, 12)) << month;
  EXPECT_FALSE(read_day("12/258/2027", '/', {}));
}

TEST(Calendar, ReadsWrittenDays) {
  EXPECT_EQ(date_text(*read_day("21/11/2026", '/', {})), "2026-11-21");
  EXPECT_EQ(date_text(*read_day("11/21/2026", '/', {})), "2026-11-21");
  EXPECT_FALSE(read_day("1/2/3/4", '/', {}));
}

TEST(Calendar, TakesTheCenturyFromTheClock) {
  const auto read = [](const char* text, const char* now) {
    return date_text(*read_day(text, '/', *parse_timestamp(now)));
  };
  EXPECT_EQ(read("3/5/46", "2026-11-21 09:00"), "2046-05-03");
  EXPECT_EQ(read("3/5/47", "2026-11-21 09:00"), "1947-05-03");
  EXPECT_EQ(read("3/5/38", "2042-11-21 09:00"), "2038-05-03");
  EXPECT_EQ(read("3/5/62", "2042-11-21 09:00"), "2062-05-03");
  EXPECT_EQ(read("3/5/63", "2042-11-21 09:00"), "1963-05-03");
  EXPECT_EQ(read("3/5/05", "2092-11-21 09:00"), "2105-05-03");
  EXPECT_FALSE(read_day("3/5/26", '/', {}));
}

TEST(Calendar, CountsMonthsToTheirLastDay) {
  const auto day = *make_day(2026, 1, 31);
  EXPECT_EQ(date_text(months_later(day, 1)), "2026-02-28");
  EXPECT_EQ(date_text(months_later(day, 12)), "2027-01-31");
  EXPECT_EQ(date_text(last_of_month(*make_day(2026, 11, 3))), "2026-11-30");
}

TEST(Calendar, KnowsNames) {
  EXPECT_EQ(month_of("sept"), 9);
  EXPECT_EQ(month_of("ma"), 0);
  EXPECT_EQ(weekday_of("tues"), std::chrono::Tuesday);
  EXPECT_EQ(weekday_of("tuesdays"), std::chrono::Tuesday);
  EXPECT_FALSE(weekday_of("someday"));
  EXPECT_FALSE(weekday_of("tuess"));
}

} // namespace
} // namespace parlour::adapters::nlu
