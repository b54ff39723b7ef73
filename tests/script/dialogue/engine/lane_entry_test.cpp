#include <gtest/gtest.h>

#include "script/dialogue/engine/lane_entry.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* holds_the_lane = R"xml(
  <topic name="T">
    <slot name="S" type="Functional" question="What?"/>
    <filled><request module="Slow" command="Go"/></filled>
    <completed><speak param="Done."/></completed>
  </topic>)xml";

TEST(LaneEntry, WhatTheUserSaysWaitsForWhatHoldsTheLane) {
  World world(holds_the_lane);
  world.components["Slow"] = {};
  world.say(inform("T", Map{{"S", "a"}}));
  world.said();
  world.say(inform("T", Map{{"S", "b"}}));
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_EQ(world.slot("T", "S"), "a");
}

TEST(LaneEntry, WhoWantsOutDoesNot) {
  World world(holds_the_lane);
  world.components["Slow"] = {};
  world.say(inform("T", Map{{"S", "a"}}));
  world.said();
  world.say("cancel");
  EXPECT_EQ(world.conversation->current_topic(), "");
  EXPECT_TRUE(world.slot("T", "S").is_unknown());
}

} // namespace
} // namespace parlour::dialogue
