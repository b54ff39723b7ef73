#include <gtest/gtest.h>

#include "adapters/metrics/turn_times.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;

TEST(TurnTimes, CountFromTheLastSound) {
  TurnTimes times;
  times.ended(10'300, 300ms);
  times.recognised(10'310);
  times.understood(10'312);
  times.said(10'315, 7);
  EXPECT_FALSE(times.sounded(10'320, 6));
  const auto turn = times.sounded(10'335, 7);
  ASSERT_TRUE(turn);
  EXPECT_EQ(to_string(Value(*turn)),
            "{speech_end: 10000, decided: 300, recognised: 310, understood: "
            "312, said: 315, first_sound: 335}");
}

TEST(TurnTimes, AreToldOnce) {
  TurnTimes times;
  times.ended(10'300, 300ms);
  times.recognised(10'310);
  times.said(10'315, 7);
  EXPECT_TRUE(times.sounded(10'335, 7));
  EXPECT_FALSE(times.sounded(10'355, 7));
}

TEST(TurnTimes, WhatDidNotHappenIsUnknown) {
  TurnTimes times;
  times.ended(10'300, 300ms);
  times.recognised(10'310);
  times.said(10'315, 7);
  const auto turn = times.sounded(10'335, 7);
  ASSERT_TRUE(turn);
  EXPECT_TRUE(Value(*turn)["understood"].is_unknown());
}

TEST(TurnTimes, TheFirstOfEachCounts) {
  TurnTimes times;
  times.ended(10'300, 300ms);
  times.recognised(10'310);
  times.recognised(10'410);
  times.said(10'315, 7);
  times.said(10'415, 8);
  EXPECT_FALSE(times.sounded(10'420, 8));
  const auto turn = times.sounded(10'435, 7);
  ASSERT_TRUE(turn);
  EXPECT_EQ(Value(*turn)["recognised"], Value(310));
}

TEST(TurnTimes, WhatIsSaidBeforeIsNoAnswer) {
  TurnTimes times;
  times.said(10'000, 6);
  EXPECT_FALSE(times.sounded(10'020, 6));
  times.ended(10'300, 300ms);
  times.said(10'305, 7);
  EXPECT_FALSE(times.sounded(10'325, 7));
}

TEST(TurnTimes, AnotherTurnTakesThePlaceOfOneWithoutAnswer) {
  TurnTimes times;
  times.ended(10'300, 300ms);
  times.recognised(10'310);
  times.said(10'315, 7);
  times.ended(12'300, 300ms);
  EXPECT_FALSE(times.sounded(12'310, 7));
}

} // namespace
} // namespace parlour::adapters
