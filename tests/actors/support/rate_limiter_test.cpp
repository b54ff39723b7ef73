#include <gtest/gtest.h>

#include "actors/support/rate_limiter.hpp"

namespace parlour::actors {
namespace {

int spend_all(RateLimiter& credit, Timestamp now) {
  int events = 0;
  while (credit.spend(now))
    ++events;
  return events;
}

TEST(RateLimiter, IsFullAtFirstAndFillsAsTimePasses) {
  RateLimiter credit;
  EXPECT_EQ(spend_all(credit, 5'000), RateLimiter::capacity);
  EXPECT_EQ(spend_all(credit, 5'000), 0);
  EXPECT_EQ(spend_all(credit, 5'010), RateLimiter::each_second / 100);
  EXPECT_EQ(spend_all(credit, 1'000'000), RateLimiter::capacity);
}

TEST(RateLimiter, IsEarnedByWork) {
  RateLimiter credit;
  spend_all(credit, 0);
  credit.earn();
  EXPECT_EQ(spend_all(credit, 0), RateLimiter::each_message);
}

TEST(RateLimiter, IsNoMoreThanItsCapacity) {
  RateLimiter credit;
  credit.earn();
  EXPECT_EQ(spend_all(credit, 0), RateLimiter::capacity);
}

} // namespace
} // namespace parlour::actors
