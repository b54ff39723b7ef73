// A yes followed by more words of the same utterance (engine rule 5.8).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

// What else is said of the topic comes first, and the question again.
TEST(Breath, AYesWithMoreIsNotActedOn) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  world.said();
  world.queue(act("confirm"));
  world.queue(act("deny"));
  world.run();
  EXPECT_EQ(world.slot("Meeting", "Host"), "Ann Lee");
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Ann Lee, type: set}]"});
  world.queue(act("confirm"));
  world.queue(inform({}, {{"Start", 9}}));
  world.run();
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Ann Lee, type: set}]"});
}

} // namespace
} // namespace parlour::dialogue
