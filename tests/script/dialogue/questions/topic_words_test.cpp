// The words about topics and slots.
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(TopicWords, ARefusedValueLeavesTheOldOne) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say(inform("Booking", {{"Place", "Moon"}}));
  EXPECT_EQ(world.said(), (Texts{"[invalid Booking.Place {value: Moon, reason: "
                                 ", type: set, choices: [Hall, Garden]}]",
                                 "When?"}));
  EXPECT_EQ(world.slot("Booking", "Place"), "Hall");
}

TEST(TopicWords, RepeatSaysTheLastTurnOnly) {
  World world(booking);
  world.say("repeat");
  EXPECT_EQ(world.said(), Texts{"[repeat_nothing]"});
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say("repeat");
  EXPECT_EQ(world.said(), (Texts{"Started.", "Place Hall.", "When?"}));
  world.say(inform({}, {{"Time", "10:00"}}));
  world.said();
  world.say("repeat");
  EXPECT_EQ(world.said(), (Texts{"Time 10:00.", "Filled.", "Completed."}));
}

} // namespace
} // namespace parlour::dialogue
