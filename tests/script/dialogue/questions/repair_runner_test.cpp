// What a <repair> can read and do (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(RepairRunner, HelpExplainsAndAsksAgain) {
  World world(booking, starting_with("Booking"));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Where?"}));
  world.say("help");
  EXPECT_EQ(world.said(), (Texts{"I need a place.", "Which place?"}));
  world.say(inform({}, {{"Place", "Hall"}}));
  world.said();
  world.say("help"); // no <explain>: in general
  EXPECT_EQ(world.said().size(), 2u);
}

TEST(RepairRunner, GoodbyeEndsTheSessionWithSomethingUnfinished) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say("bye");
  EXPECT_EQ(world.said(), Texts{"[bye {unfinished: [Booking]}]"});
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.timers(), 0u);
}

} // namespace
} // namespace parlour::dialogue
