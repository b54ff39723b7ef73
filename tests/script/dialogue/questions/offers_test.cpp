// A reaction to source Dialogue may consume an act.
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* desk = R"xml(
  <topic name="Taxi"><slot name="Street" type="Functional"
    question="Which street?"/></topic>
  <handler name="Desk"><messages><component><Dialogue>
    <inform><speak param="Heard."/>
      <if cond="_LPARAM1.slots.Street"><consume/></if></inform>
  </Dialogue></component></messages></handler>)xml";

TEST(Offers, WhatIsConsumedGoesNoFurther) {
  World world(desk);
  world.say(inform("Taxi", {}));
  EXPECT_EQ(world.said(), (Texts{"Heard.", "Which street?"}));
  world.say(inform({}, {{"Street", "Main"}}));
  EXPECT_EQ(world.said().front(), "Heard.");
  EXPECT_EQ(world.slot("Taxi", "Street"), Value());
}

} // namespace
} // namespace parlour::dialogue
