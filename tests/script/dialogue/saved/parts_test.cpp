// Parts of a conversation that come back in the middle of something.
#include "script/dialogue/agenda/lane.hpp"
#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/agenda/saved_step.hpp"
#include "script/dialogue/agenda/state_stack.hpp"
#include "script/dialogue/agenda/turns.hpp"
#include "script/dialogue/context/apologies.hpp"
#include "script/dialogue/topics/topic_order.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

TEST(SavedParts, ALaneThatWaits) {
  Lane lane;
  lane.queue(StepList(steps::AskNext{1}, steps::Conclude{1}));
  lane.next();
  lane.wait(5, Lane::Others::go_on);
  lane.queue(StepList(steps::Conclude{2}));
  lane.next();
  lane.wait(6, Lane::Others::are_held);
  auto again = round_trip(lane);
  EXPECT_TRUE(again.waits(5));
  EXPECT_TRUE(again.held());
  EXPECT_EQ(again.next(), nullptr);
  EXPECT_TRUE(again.wake(6, StepList(steps::Conclude{9})));
  EXPECT_EQ(turn_of(*again.next()), 9u);
}

TEST(SavedParts, AnOutputQueueWithWordsThatWereCut) {
  OutputQueue queue;
  const auto first = queue.push({.text = "one two"});
  queue.release(false);
  queue.cut(first, "one");
  queue.push({.act = OutputAct::question, .text = "three?"});
  auto again = round_trip(queue);
  EXPECT_EQ(again.last_turn(), std::vector<std::string>{"one"});
  EXPECT_EQ(again.release(true).withdrawn.size(), 1u);
  EXPECT_EQ(again.push({}), first + 2);
}

TEST(SavedParts, TurnsThatAreOpen) {
  Turns turns;
  const auto first = turns.begin();
  turns.asked(11, first, 5'000, true);
  const auto second = turns.begin();
  turns.hold(second);
  turns.asked(12, second, 6'000);
  turns.answered(12);
  turns.speaks(900);
  auto again = round_trip(turns);
  EXPECT_EQ(again.count(), 2u);
  EXPECT_EQ(again.of(12), second);
  EXPECT_TRUE(again.speaking(800));
  EXPECT_EQ(again.expire(5'000), std::vector<TurnId>{first});
  EXPECT_TRUE(again.any_said(5'000));
  EXPECT_EQ(again.begin(), second + 1);
}

TEST(SavedParts, StatesThatWerePushed) {
  StateStack states;
  states.enter(0);
  states.push({.wait = 5});
  states.enter(0);
  auto again = round_trip(states);
  EXPECT_TRUE(again.was_pushed_for(5));
  EXPECT_EQ(again.visit(), states.visit());
  EXPECT_TRUE(again.lasts(1));
}

TEST(SavedParts, AStackOfStatesHasALevel) {
  const auto program = small_program();
  auto bytes = bytes_of(program, StateStack());
  // Visits 0, one level: state, visit, who pushed it.
  bytes.erase(bytes.size() - 5);
  StateStack states;
  EXPECT_FALSE(read(program, states, bytes + std::string("\0", 1)));
}

TEST(SavedParts, ApologiesAreNotDueTwice) {
  Apologies apologies;
  EXPECT_TRUE(apologies.due(1'000));
  auto again = round_trip(apologies);
  EXPECT_FALSE(again.due(2'000));
  EXPECT_TRUE(again.due(11'000));
}

TEST(SavedParts, TopicsInTheirOrder) {
  const auto program = small_program();
  TopicOrder order(*program);
  order.activate(0);
  TopicOrder again(*program);
  const auto done = read(program, again, bytes_of(program, order));
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(again.current(), 0u);
  again.unregister_topic(0);
  EXPECT_NE(bytes_of(program, again), bytes_of(program, order));
}

} // namespace
} // namespace parlour::dialogue
