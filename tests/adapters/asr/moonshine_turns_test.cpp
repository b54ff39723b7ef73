#include <gmock/gmock.h>

#include "adapters/asr/moonshine_turns.hpp"

namespace parlour::adapters::moonshine {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Message order(const SessionId& session, const std::string& command = "Finish") {
  Message message;
  message.session = session;
  message.command = command;
  message.params = {"much audio"};
  return message;
}

TEST(MoonshineTurns, EachTurnHasANumberOfItsOwn) {
  MoonshineTurns turns;
  const auto first = turns.add(order("one"), 10).turn;
  EXPECT_FALSE(turns.add(order("one"), 10).is_new);
  EXPECT_EQ(turns.add(order("one"), 10).turn, first);
  EXPECT_NE(turns.add(order("two"), 10).turn, first);
  EXPECT_EQ(turns.finish(order("one")), first);
  const auto next = turns.add(order("one"), 10);
  EXPECT_TRUE(next.is_new);
  EXPECT_NE(next.turn, first);
  EXPECT_EQ(turns.finish(order("three")), std::nullopt);
}

TEST(MoonshineTurns, AnswersBelongToTheirOrders) {
  MoonshineTurns turns;
  const auto turn = turns.add(order("one", "DoRecognition"), 10).turn;
  const auto partial = turns.partial(turn);
  ASSERT_TRUE(partial);
  EXPECT_EQ(partial->order.command, "DoRecognition");
  EXPECT_THAT(partial->order.params, IsEmpty());
  EXPECT_EQ(partial->revision, 1);
  EXPECT_EQ(turns.partial(turn)->revision, 2);
  EXPECT_FALSE(turns.take(turn));
  turns.finish(order("one"));
  EXPECT_FALSE(turns.partial(turn));
  EXPECT_EQ(turns.take(turn)->command, "Finish");
  EXPECT_FALSE(turns.take(turn));
}

TEST(MoonshineTurns, HasAnEnd) {
  MoonshineTurns turns;
  constexpr auto most = MoonshineTurns::max_samples;
  EXPECT_EQ(turns.add(order("one"), most - 1).samples, most - 1);
  EXPECT_EQ(turns.add(order("one"), 10).samples, 1U);
  EXPECT_EQ(turns.add(order("one"), 10).samples, 0U);
}

TEST(MoonshineTurns, TheOldestGivesWay) {
  MoonshineTurns turns;
  const auto first = turns.add(order("0"), 1).turn;
  for (std::size_t one = 1; one < MoonshineTurns::max_spoken; ++one)
    EXPECT_FALSE(turns.add(order(std::to_string(one)), 1).dropped);
  EXPECT_EQ(turns.add(order("new"), 1).dropped, first);
  EXPECT_FALSE(turns.finish(order("0")));
}

TEST(MoonshineTurns, FinishedOnesAreBounded) {
  MoonshineTurns turns;
  for (std::size_t one = 0; one < MoonshineTurns::max_finished; ++one) {
    EXPECT_TRUE(turns.has_room());
    turns.add(order("one"), 1);
    turns.finish(order("one"));
  }
  EXPECT_FALSE(turns.has_room());
  turns.take(1);
  EXPECT_TRUE(turns.has_room());
}

TEST(MoonshineTurns, CancelsThoseOfASession) {
  MoonshineTurns turns;
  turns.add(order("one"), 1);
  turns.finish(order("one"));
  turns.add(order("one"), 1);
  turns.add(order("two"), 1);
  const auto cancelled = turns.cancel("one");
  EXPECT_THAT(cancelled.turns, ElementsAre(1, 2));
  EXPECT_EQ(cancelled.orders.size(), 1U);
  EXPECT_FALSE(turns.finish(order("one")));
  EXPECT_TRUE(turns.finish(order("two")));
  EXPECT_EQ(turns.take_all().size(), 1U);
  EXPECT_THAT(turns.take_all(), IsEmpty());
}

} // namespace
} // namespace parlour::adapters::moonshine
