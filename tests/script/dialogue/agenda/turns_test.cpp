#include <gtest/gtest.h>

#include "script/dialogue/agenda/turns.hpp"

namespace parlour::dialogue {
namespace {

TEST(Turns, OpenWhileSomethingHoldsThem) {
  Turns turns;
  auto turn = turns.begin();
  turns.hold(turn);
  EXPECT_TRUE(turns.any_open(0));
  EXPECT_EQ(turns.open_until(0), std::nullopt);
  turns.let_go(turn);
  EXPECT_FALSE(turns.any_open(0));
  EXPECT_EQ(turns.count(), 0u);
}

TEST(Turns, OpenWhileAComponentIsAsked) {
  Turns turns;
  auto turn = turns.begin();
  turns.hold(turn);
  turns.asked(7, turn, 100);
  turns.let_go(turn);
  EXPECT_TRUE(turns.any_open(99));
  EXPECT_EQ(turns.open_until(99), 100);
  EXPECT_FALSE(turns.any_open(100));
  EXPECT_EQ(turns.of(7), turn);
  turns.answered(7);
  EXPECT_FALSE(turns.any_open(0));
  EXPECT_EQ(turns.of(7), turn); // a second answer is still of this turn
  EXPECT_EQ(turns.of(8), 0u);
}

TEST(Turns, ClosedOnceTakenUp) {
  Turns turns;
  auto turn = turns.begin();
  turns.hold(turn);
  turns.taken_up(turn);
  EXPECT_FALSE(turns.any_open(0));
  turns.let_go(turn);
  EXPECT_EQ(turns.count(), 0u);
}

TEST(Turns, ExpireWithTheirQuestions) {
  Turns turns;
  auto turn = turns.begin();
  turns.hold(turn);
  turns.asked(7, turn, 100);
  turns.let_go(turn);
  turns.expire(99);
  EXPECT_EQ(turns.count(), 1u);
  turns.expire(100);
  EXPECT_EQ(turns.count(), 0u);
}

TEST(Turns, NeverGrowWithoutBound) {
  Turns turns;
  for (Correlation number = 1; number <= 5000; ++number) {
    auto turn = turns.begin();
    turns.hold(turn);
    turns.asked(number, turn, 1'000'000);
    turns.let_go(turn);
  }
  EXPECT_LE(turns.count(), 300u);
}

TEST(Turns, WhoIsHeardToSpeakHasATurnForAWhile) {
  Turns turns;
  turns.speaks(100);
  EXPECT_TRUE(turns.any_open(99));
  EXPECT_EQ(turns.open_until(0), 100);
  EXPECT_FALSE(turns.any_open(100));
  turns.speaks(200);
  turns.speech_is_over();
  EXPECT_FALSE(turns.any_open(101));
  turns.speaks(200);
  turns.taken_up(turns.begin()); // its result
  EXPECT_FALSE(turns.any_open(101));
}

TEST(Turns, NoTurnIsNothing) {
  Turns turns;
  turns.hold(0);
  turns.asked(1, 0, 100);
  turns.let_go(0);
  turns.answered(5);
  EXPECT_FALSE(turns.any_open(0));
  EXPECT_EQ(turns.of(1), 0u);
}

} // namespace
} // namespace parlour::dialogue
