// Acts about the conversation itself: help, cancel, repeat …
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(RepairActs, ACancelIsOfTheTopicThatIsAskedAbout) {
  World world(booking, starting_with("Booking"));
  world.said();
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"[cancelled Booking]", "Cancelled."}));
}

} // namespace
} // namespace parlour::dialogue
