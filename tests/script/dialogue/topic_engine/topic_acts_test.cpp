// Which topic an act goes to (engine rule 5, "Acts").
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(TopicActs, AYesThatNobodyAskedForIsAcknowledged) {
  World world(booking);
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"[acknowledge]"});
}

TEST(TopicActs, UnregisteredTopicsTakeNoPart) {
  World world(std::string(booking) + R"xml(
    <handler name="H"><messages><component>
      <Door><Shut><unregister topic="Taxi"/></Shut>
        <Opened><register topic="Taxi"/></Opened></Door>
    </component></messages></handler>)xml");
  world.components["Door"] = {};
  world.event("Door", "Shut");
  world.say(inform("Taxi", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
  world.event("Door", "Opened");
  world.say(inform("Taxi", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
}

} // namespace
} // namespace parlour::dialogue
