#include <gtest/gtest.h>

#include "runtime/base/rate_limit.hpp"

namespace parlour {
namespace {

using std::chrono::milliseconds;

int admitted(RateLimit& limit, RateLimit::Moment now, int tries) {
  int count = 0;
  for (int i = 0; i < tries; ++i)
    count += limit.admit(now) ? 1 : 0;
  return count;
}

TEST(RateLimit, LetsSoManyPassInASecond) {
  RateLimit limit(10);
  RateLimit::Moment now{milliseconds(5'000)};
  EXPECT_EQ(admitted(limit, now, 50), 10);
  now += milliseconds(500);
  EXPECT_EQ(admitted(limit, now, 50), 5);
  now += milliseconds(60'000);
  EXPECT_EQ(admitted(limit, now, 50), 10); // no more are saved up
}

TEST(RateLimit, LetsMorePassAtOnce) {
  RateLimit limit(10, 20);
  RateLimit::Moment now{milliseconds(5'000)};
  EXPECT_EQ(admitted(limit, now, 50), 20);
  now += milliseconds(1'000);
  EXPECT_EQ(admitted(limit, now, 50), 10);
}

} // namespace
} // namespace parlour
