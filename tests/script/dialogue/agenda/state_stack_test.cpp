#include <gtest/gtest.h>

#include "script/dialogue/agenda/state_stack.hpp"

namespace parlour::dialogue {
namespace {

std::vector<StateId> states(const StateStack& stack) {
  std::vector<StateId> all;
  for (const auto& level : stack.levels())
    all.push_back(level.state);
  return all;
}

TEST(StateStack, EntersOnTheSameLevel) {
  StateStack stack;
  EXPECT_EQ(stack.active(), script::no_id);
  stack.enter(1);
  stack.enter(2);
  EXPECT_EQ(states(stack), std::vector<StateId>{2});
  EXPECT_FALSE(stack.pushed());
}

TEST(StateStack, PushAndPop) {
  StateStack stack;
  stack.enter(1);
  stack.push({.wait = 7, .topic = 4});
  stack.enter(2);
  stack.enter(3); // a transit in a pushed state changes that level
  EXPECT_EQ(states(stack), (std::vector<StateId>{1, 3}));
  EXPECT_TRUE(stack.pushed());
  EXPECT_EQ(stack.pop().wait, 7u);
  EXPECT_EQ(stack.active(), 1u);
  EXPECT_FALSE(stack.pushed());
}

TEST(StateStack, KnowsWhoPushed) {
  StateStack stack;
  EXPECT_FALSE(stack.was_pushed_by(script::no_id));
  EXPECT_FALSE(stack.was_pushed_for(0));
  stack.push({.wait = 7, .topic = 4});
  stack.push({.wait = 8});
  EXPECT_TRUE(stack.was_pushed_by(4));
  EXPECT_FALSE(stack.was_pushed_by(5));
  EXPECT_TRUE(stack.was_pushed_for(7));
  EXPECT_FALSE(stack.was_pushed_for(9));
}

TEST(StateStack, AVisitLastsUntilItsStateIsLeft) {
  StateStack stack;
  EXPECT_EQ(stack.visit(), 0u);
  stack.enter(1);
  const auto first = stack.visit();
  stack.push({});
  stack.enter(2);
  const auto pushed = stack.visit();
  EXPECT_TRUE(stack.lasts(first));
  EXPECT_TRUE(stack.lasts(pushed));
  stack.pop();
  EXPECT_FALSE(stack.lasts(pushed));
  EXPECT_EQ(stack.visit(), first);
  stack.enter(1); // anew
  EXPECT_FALSE(stack.lasts(first));
  stack.enter(script::no_id);
  EXPECT_EQ(stack.visit(), 0u);
}

} // namespace
} // namespace parlour::dialogue
