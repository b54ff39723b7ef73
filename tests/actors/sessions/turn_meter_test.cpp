#include <gtest/gtest.h>

#include "actors/sessions/turn_meter.hpp"
#include "runtime/message/typed_turn.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(TurnMeter, EachLineWithoutANumberIsATurn) {
  TurnMeter meter;
  EXPECT_EQ(meter.number(), 0u);
  EXPECT_EQ(meter.take_answered().turns, 0u);
  meter.take(2, 0, 0, 100);
  meter.take(1, 0, 0, 200);
  EXPECT_EQ(meter.number(), 3u);
  const auto answered = meter.take_answered();
  EXPECT_EQ(answered.turns, 3u);
  EXPECT_EQ(answered.since, 100); // the first of them
  EXPECT_EQ(meter.take_answered().turns, 0u);
  meter.take(1, 0, 0, 300);
  EXPECT_EQ(meter.take_answered().since, 300);
}

TEST(TurnMeter, LinesBelongToTheTurnWithTheNumber) {
  TurnMeter meter;
  meter.go_on(6);
  meter.take(2, 1, 7, 100);
  EXPECT_EQ(meter.number(), 7u);
  EXPECT_EQ(meter.take_answered().turns, 1u);
  meter.take(0, 0, 7, 200); // nobody said anything
  EXPECT_EQ(meter.take_answered().turns, 0u);
}

// Whoever numbers turns is told once that they are answered.
TEST(TurnMeter, TellsTheHighestNumberOnce) {
  Bench bench;
  TurnMeter meter;
  meter.go_on(6);
  EXPECT_EQ(meter.take_done(), 6u); // it is asked again after a crash
  EXPECT_FALSE(meter.take({Message{}}, bench.bus, 1));
  EXPECT_TRUE(
      meter.take({typed_turn("a", 0), typed_turn("b", 7)}, bench.bus, 2));
  EXPECT_EQ(meter.number(), 7u);
  EXPECT_EQ(meter.take_answered().turns, 1u);
  EXPECT_EQ(meter.take_done(), 7u);
  EXPECT_EQ(meter.take_done(), 0u);
}

} // namespace
} // namespace parlour::actors
