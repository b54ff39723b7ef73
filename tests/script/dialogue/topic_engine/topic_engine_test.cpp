// Starting the conversation over (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(TopicEngine, StartOverBeginsAgain) {
  World world(booking, starting_with("Booking"));
  world.say(inform({}, {{"Place", "Hall"}}));
  world.said();
  world.say("restart");
  EXPECT_EQ(world.said(), (Texts{"[restarted]", "Started.", "Where?"}));
  EXPECT_EQ(world.slot("Booking", "Place"), Value());
}

} // namespace
} // namespace parlour::dialogue
