#include <gtest/gtest.h>

#include "script/values/walk_budget.hpp"

namespace parlour::script {

namespace {

TEST(WalkBudget, FourValuesOrThirtyTwoBytesAreAnInstruction) {
  WalkBudget budget(1000);
  EXPECT_TRUE(budget.values(4));
  EXPECT_EQ(budget.price(), 1u);
  EXPECT_TRUE(budget.bytes(32));
  EXPECT_EQ(budget.price(), 2u);
  EXPECT_EQ(budget.left(), 936u);
  EXPECT_EQ(WalkBudget::price_of_values(8), WalkBudget::price_of_bytes(64));
}

TEST(WalkBudget, WhatIsExhaustedStaysSoAndCostsAllThatWasGiven) {
  WalkBudget budget(64);
  EXPECT_FALSE(budget.bytes(65));
  EXPECT_TRUE(budget.exhausted());
  EXPECT_FALSE(budget.bytes(0));
  EXPECT_EQ(budget.price(), 2u);
  WalkBudget given_up(64);
  given_up.exhaust();
  EXPECT_FALSE(given_up.values());
}

TEST(WalkBudget, AllOfItCanBeTaken) {
  WalkBudget budget(64);
  EXPECT_TRUE(budget.values(8));
  EXPECT_FALSE(budget.exhausted());
  EXPECT_EQ(budget.left(), 0u);
}

} // namespace

} // namespace parlour::script
