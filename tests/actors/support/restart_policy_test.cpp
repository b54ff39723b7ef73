#include <gtest/gtest.h>

#include "actors/support/restart_policy.hpp"

namespace parlour::actors {
namespace {

using namespace std::chrono_literals;
using Verdict = RestartPolicy::Verdict;

TEST(RestartPolicy, BacksOffAndGoesDownAtTheFifthInAMinute) {
  RestartPolicy record;
  EXPECT_EQ(record.failed(1'000), (Verdict{false, 0ms}));
  EXPECT_EQ(record.failed(2'000), (Verdict{false, 100ms}));
  EXPECT_EQ(record.failed(3'000), (Verdict{false, 200ms}));
  EXPECT_EQ(record.failed(4'000), (Verdict{false, 400ms}));
  EXPECT_EQ(record.failed(60'999), (Verdict{true, 1min}));
  EXPECT_EQ(record.count(), 5);
}

TEST(RestartPolicy, ForgetsWhatIsOlderThanAMinute) {
  RestartPolicy record;
  for (Timestamp now = 0; now <= 600'000; now += 15'000)
    EXPECT_FALSE(record.failed(now).down) << now;
  EXPECT_EQ(record.failed(660'000), (Verdict{false, 0ms}));
}

TEST(RestartPolicy, RestsTwiceAsLongWhenItFailsOnItsReturn) {
  RestartPolicy record;
  for (int i = 0; i < 4; ++i)
    record.failed(0);
  Timestamp now = 0;
  for (const auto rest : {1min, 2min, 4min, 8min, 16min, 16min}) {
    const auto verdict = record.failed(now);
    EXPECT_EQ(verdict, (Verdict{true, rest}));
    now += verdict.pause.count() + 1;
  }
}

TEST(RestartPolicy, BeginsAnewAfterAGoodMinute) {
  RestartPolicy record;
  for (int i = 0; i < 5; ++i)
    record.failed(0);
  EXPECT_EQ(record.failed(120'000), (Verdict{false, 0ms}));
  for (int i = 0; i < 3; ++i)
    record.failed(120'000);
  EXPECT_EQ(record.failed(120'000), (Verdict{true, 1min}));
}

} // namespace
} // namespace parlour::actors
