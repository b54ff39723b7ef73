#include <gtest/gtest.h>

#include "script/program/timer_limits.hpp"

namespace parlour::script {

namespace {

TEST(TimerLimits, AreOfNumberAndOfMemory) {
  EXPECT_FALSE(refuse_timers(1000, 100, 100));
  EXPECT_EQ(refuse_timers(1001, 0, 100)->message,
            "more than 1000 timers at once");
  EXPECT_EQ(refuse_timers(1, 101, 100)->message,
            "what the timers remember takes more than 100 bytes");
}

TEST(TimerLimits, LocalsAreCountedAsTheirBytes) {
  EXPECT_EQ(remembered({}), 0u);
  EXPECT_GE(remembered({Value(std::string(1000, 'x')), Value(1)}), 1000u);
}

} // namespace

} // namespace parlour::script
