#include <gtest/gtest.h>

#include "script/dialogue/agenda/lane.hpp"

namespace parlour::dialogue {
namespace {

steps::Run numbered(TurnId number) {
  return {{.turn = number}};
}

// The numbers of the steps that can be taken.
std::vector<TurnId> taken(Lane& lane) {
  std::vector<TurnId> numbers;
  while (auto step = lane.next())
    numbers.push_back(turn_of(*step));
  return numbers;
}

using Numbers = std::vector<TurnId>;

TEST(Lane, ItemsOneAfterTheOther) {
  Lane lane;
  lane.queue({numbered(1), numbered(2)});
  lane.queue({numbered(3)});
  lane.queue({});
  EXPECT_FALSE(lane.idle());
  EXPECT_EQ(taken(lane), (Numbers{1, 2, 3}));
  EXPECT_TRUE(lane.idle());
}

TEST(Lane, AStepStaysWhereItIsWhileItIsTaken) {
  Lane lane;
  lane.queue({numbered(1), numbered(9)});
  const auto* step = lane.next();
  for (TurnId number = 8; number > 2; --number)
    lane.at_once(numbered(number));
  EXPECT_TRUE(lane.abandon().empty());
  EXPECT_EQ(turn_of(*step), 1u);
  lane.at_once(numbered(2));
  EXPECT_EQ(taken(lane), Numbers{2});
}

TEST(Lane, WhatComesWhileAStepIsTakenWaitsBehindIt) {
  Lane lane;
  lane.queue({numbered(1)});
  lane.next();
  lane.queue({numbered(3)});
  lane.wait(9, Lane::Others::go_on); // the item is not its own
  EXPECT_EQ(turn_of(*lane.next()), 3u);
  lane.wake(9, numbered(2));
  EXPECT_EQ(taken(lane), (Numbers{2}));
}

TEST(Lane, NowGoesInFront) {
  Lane lane;
  lane.queue({numbered(1), numbered(4)});
  EXPECT_EQ(turn_of(*lane.next()), 1u);
  lane.now({numbered(2), numbered(3)});
  EXPECT_EQ(taken(lane), (Numbers{2, 3, 4}));
}

TEST(Lane, AWaitHoldsItButForWhatItsScriptHandedOver) {
  Lane lane;
  lane.queue({numbered(1), numbered(5)});
  lane.queue({numbered(6)});
  lane.next();
  lane.wait(9, Lane::Others::are_held);
  lane.now({numbered(2), numbered(3)});
  EXPECT_EQ(taken(lane), (Numbers{2, 3}));
  EXPECT_TRUE(lane.held());
  EXPECT_FALSE(lane.idle());
  EXPECT_TRUE(lane.waits());
  EXPECT_TRUE(lane.wake(9, numbered(4)));
  EXPECT_EQ(taken(lane), (Numbers{4, 5, 6}));
  EXPECT_TRUE(lane.idle());
}

TEST(Lane, AWaitForTheUserLetsItemsBeTaken) {
  Lane lane;
  lane.queue({numbered(1), numbered(4)});
  lane.next();
  lane.wait(9, Lane::Others::go_on);
  EXPECT_TRUE(lane.idle());
  EXPECT_TRUE(lane.waits());
  EXPECT_FALSE(lane.held());
  lane.queue({numbered(2), numbered(3)});
  EXPECT_FALSE(lane.idle());
  EXPECT_EQ(turn_of(*lane.next()), 2u);
  EXPECT_FALSE(lane.returning());
  EXPECT_TRUE(lane.wake(9, numbered(5)));
  EXPECT_TRUE(lane.returning());
  lane.queue({numbered(6)});
  EXPECT_EQ(taken(lane), (Numbers{3, 5, 4, 6}));
}

TEST(Lane, OtherActsDoNotWaitForTheUser) {
  Lane lane;
  lane.queue({numbered(1), steps::TakeAct{.turn = 2}, numbered(3),
              steps::Conclude{4}});
  lane.queue({numbered(5)});
  lane.next();
  lane.wait(9, Lane::Others::go_on);
  EXPECT_EQ(taken(lane), (Numbers{2, 4, 5}));
  lane.wake(9, numbered(6));
  EXPECT_EQ(taken(lane), (Numbers{6, 3, 4}));
}

// What has waited does not wait for others that wait.
TEST(Lane, WhatHasWaitedGoesOnBesideOthersThatWait) {
  Lane lane;
  lane.queue({numbered(1), numbered(5)});
  lane.next();
  lane.wait(8, Lane::Others::go_on);
  lane.queue({numbered(2), numbered(6)});
  EXPECT_EQ(turn_of(*lane.next()), 2u);
  lane.wait(9, Lane::Others::go_on);
  lane.wake(8, numbered(4));
  EXPECT_FALSE(lane.idle());
  EXPECT_EQ(taken(lane), (Numbers{4, 5}));
  EXPECT_TRUE(lane.waits(9));
  lane.wake(9, numbered(7));
  EXPECT_EQ(taken(lane), (Numbers{7, 6}));
  EXPECT_TRUE(lane.idle());
  EXPECT_FALSE(lane.waits());
}

TEST(Lane, OneThatHoldsItHoldsAllThatIsQueued) {
  Lane lane;
  lane.queue({numbered(1)});
  lane.next();
  lane.wait(8, Lane::Others::are_held);
  lane.now({numbered(2)});
  lane.next();
  lane.wait(9, Lane::Others::go_on);
  lane.queue({numbered(3)});
  EXPECT_EQ(taken(lane), Numbers{});
  lane.wake(8, numbered(4));
  EXPECT_EQ(taken(lane), (Numbers{4, 3}));
}

TEST(Lane, OneThatHoldsItHoldsWhatHasWaited) {
  Lane lane;
  lane.queue({numbered(1), numbered(5)});
  lane.next();
  lane.wait(8, Lane::Others::go_on);
  lane.queue({numbered(2), numbered(6)});
  lane.next();
  lane.wait(9, Lane::Others::are_held);
  lane.wake(8, numbered(4));
  EXPECT_EQ(taken(lane), Numbers{});
  lane.wake(9, numbered(7));
  EXPECT_EQ(taken(lane), (Numbers{7, 6, 4, 5}));
}

TEST(Lane, WakingWhatDoesNotWait) {
  Lane lane;
  EXPECT_FALSE(lane.wake(1, numbered(1)));
  EXPECT_FALSE(lane.next());
}

TEST(Lane, AbandonGivesTheWaitsInnermostFirst) {
  Lane lane;
  lane.queue({numbered(1), numbered(2)});
  lane.next();
  lane.wait(8, Lane::Others::go_on);
  lane.queue({numbered(3), numbered(4)});
  lane.next();
  lane.wait(9, Lane::Others::are_held);
  lane.queue({numbered(5)});
  EXPECT_EQ(lane.abandon(), (std::vector<WaitId>{9, 8}));
  EXPECT_EQ(taken(lane), Numbers{5});
  EXPECT_FALSE(lane.waits(8));
}

TEST(Lane, ClearDropsWhatIsQueued) {
  Lane lane;
  lane.queue({numbered(1)});
  lane.clear();
  EXPECT_TRUE(lane.idle());
}

TEST(Lane, WhoWaitsForTheUserDoesNotHoldWhatIsAnswered) {
  Lane lane;
  lane.queue({numbered(1), numbered(5)});
  lane.next();
  lane.wait(8, Lane::Others::go_on);
  lane.queue({numbered(2), numbered(6)});
  lane.next();
  lane.wait(9, Lane::Others::go_on);
  lane.queue({numbered(3), numbered(7)});
  lane.next();
  lane.wake(8, numbered(4)); // the outer one; what runs now ends first
  EXPECT_EQ(taken(lane), (Numbers{7, 4, 5}));
  lane.wake(9, numbered(8));
  EXPECT_EQ(taken(lane), (Numbers{8, 6}));
}

TEST(Lane, WhatFollowsAWaitComesOnce) {
  Lane lane;
  lane.queue({numbered(1), numbered(4)});
  lane.next();
  lane.wait(9, Lane::Others::go_on);
  lane.follow(9, steps::Settle{0});
  lane.follow(9, steps::Settle{0});
  lane.follow(9, steps::Settle{1});
  lane.follow(7, steps::Settle{2}); // nothing waits so
  lane.wake(9, numbered(2));
  EXPECT_EQ(taken(lane), (Numbers{2, 0, 0, 4}));
}

TEST(Lane, WhatIsTakenOutIsOver) {
  Lane lane;
  lane.queue({numbered(1), numbered(3)});
  lane.next();
  lane.wait(9, Lane::Others::go_on);
  const auto rest = lane.take_out(9);
  EXPECT_EQ(turn_of(*rest.begin()), 3u);
  EXPECT_TRUE(lane.take_out(9).empty());
  EXPECT_FALSE(lane.waits(9));
  EXPECT_EQ(taken(lane), Numbers{});
  lane.queue({numbered(4)});
  EXPECT_EQ(taken(lane), Numbers{4});
}

TEST(Lane, AbandonsAllButWhatStays) {
  Lane lane;
  for (const WaitId wait : {7u, 8u, 9u}) {
    lane.queue({numbered(wait), numbered(wait * 10)});
    lane.next();
    lane.wait(wait, Lane::Others::go_on);
  }
  EXPECT_EQ(lane.abandon({8}), (std::vector<WaitId>{9, 7}));
  EXPECT_EQ(taken(lane), Numbers{});
  lane.wake(8, numbered(1));
  EXPECT_EQ(taken(lane), (Numbers{1, 80}));
}

TEST(Lane, WhatItHasAheadCanBeTaken) {
  Lane lane;
  lane.queue({numbered(1), numbered(2), numbered(3)});
  lane.next();
  const auto odd =
      lane.take_ahead([](const Step& step) { return turn_of(step) % 2 == 1; });
  EXPECT_EQ(turn_of(*odd.begin()), 3u);
  EXPECT_EQ(turn_of(*lane.ahead().begin()), 2u);
  lane.wait(9, Lane::Others::go_on);
  const auto waiting = lane.take_waiting([](const Step&) { return true; });
  EXPECT_EQ(turn_of(*waiting.begin()), 2u);
}

} // namespace
} // namespace parlour::dialogue
