// Messages that nobody takes, and words that mean nothing (engine rule 1.4).
#include <gtest/gtest.h>

#include "script/dialogue/engine/message_end.hpp"
#include "tests/script/dialogue/bell.hpp"
#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(MessageEnd, WhatNobodyTakesIsShown) {
  Bell world("<speak param='Bell.'/>");
  world.event("Bell", "Stops");
  EXPECT_EQ(world.seen(InspectionKind::unhandled).size(), 1u);
  world.ring();
  EXPECT_EQ(world.seen(InspectionKind::unhandled).size(), 1u);
}

TEST(MessageEnd, AnErrorThatNobodyTakesIsApologisedForOnce) {
  Bell world("<throw expr=\"'bad'\"/>");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"[unavailable {reason: bad}]"});
  world.ring();
  EXPECT_EQ(world.said(), Texts{});
}

TEST(MessageEnd, WordsThatMeanNothingLeadToTheQuestionAgain) {
  World world(booking, starting_with("Booking"));
  world.components["Grammar"] = {"NLU"};
  world.said();
  world.event("Grammar", "NoResult");
  EXPECT_FALSE(world.said().empty());
}

} // namespace
} // namespace parlour::dialogue
