// Corrections of what is done (engine rule 5.3).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(LateCorrections, ACorrectionIsOfWhatWasJustDone) {
  World world(booking);
  world.say(inform("Taxi", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
  world.say(act("correct", {}, {{"Street", "High"}}));
  EXPECT_EQ(world.said(), Texts{"That is already done. Shall I do it again "
                                "with this change?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
  EXPECT_EQ(world.slot("Taxi", "Street"), "High");
}

// "My number is 98765432" names no topic; the ride that was just booked has no
// number yet.
TEST(LateCorrections, WhatIsMissingThereIsOfWhatWasJustDone) {
  World world(R"xml(
    <topic name="Visit"><slot name="Phone" type="Functional"/></topic>
    <topic name="Ride">
      <slot name="Street" type="Functional"/>
      <slot name="Phone"/>
      <completed><speak param="It comes."/></completed>
    </topic>
    <repair act="correct" topic="Ride"><speak param="Noted."/></repair>)xml");
  world.say(inform("Ride", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"It comes."});
  world.say(inform("", {{"Phone", "98765432"}}));
  EXPECT_EQ(world.said(), Texts{"Noted."});
}

} // namespace
} // namespace parlour::dialogue
