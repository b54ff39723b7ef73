// What the robot asks after an utterance was handled (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(NextQuestion, AsksInSlotOrderAndTakesMoreThanAskedFor) {
  World world(booking);
  world.say(inform("Booking", {{"Name", "Ann"}}));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Where?"}));
  world.say(inform({}, {{"Time", "10:30"}}));
  EXPECT_EQ(world.said(), (Texts{"Time 10:30.", "Which place?"}));
  world.say(inform({}, {{"Place", "garden"}}));
  EXPECT_EQ(world.said(), (Texts{"Place Garden.", "Filled.", "Completed."}));
}

} // namespace
} // namespace parlour::dialogue
