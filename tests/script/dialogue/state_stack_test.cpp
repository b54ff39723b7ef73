#include <gtest/gtest.h>

#include "script/dialogue/state_stack.hpp"

namespace parlour::dialogue {
namespace {

TEST(StateStack, EntersOnTheSameLevel) {
  StateStack stack;
  EXPECT_EQ(stack.active(), script::no_id);
  stack.enter(1);
  stack.enter(2);
  EXPECT_EQ(stack.levels(), std::vector<StateId>{2});
  EXPECT_FALSE(stack.pushed());
}

TEST(StateStack, PushAndPop) {
  StateStack stack;
  stack.enter(1);
  stack.push(2);
  stack.enter(3); // a transit in a pushed state changes that level
  EXPECT_EQ(stack.levels(), (std::vector<StateId>{1, 3}));
  EXPECT_TRUE(stack.pushed());
  EXPECT_TRUE(stack.pop());
  EXPECT_EQ(stack.active(), 1u);
  EXPECT_FALSE(stack.pop());
}

} // namespace
} // namespace parlour::dialogue
