// What a yes or no leads to (engine rule 5.8).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(YesOrNoOutcome, AYesAcceptsAValueInDoubt) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Ann Lee, type: set}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Host Ann Lee.", "From?"}));
}

TEST(YesOrNoOutcome, ANoTakesItBack) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  world.said();
  world.say("deny");
  EXPECT_EQ(world.said(), Texts{"Whom?"});
  EXPECT_EQ(world.slot("Meeting", "Host"), Value());
}

} // namespace
} // namespace parlour::dialogue
