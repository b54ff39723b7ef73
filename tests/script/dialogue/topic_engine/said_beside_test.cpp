// What is said beside a yes or no (engine rule 5.8).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

const Texts asked_again{"[confirm Meeting.Host {value: Ann Lee, type: set}]"};

struct SaidBesideTest : testing::Test {
  SaidBesideTest() : world(meeting) {
    world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
    world.said();
  }
  World world;
};

TEST_F(SaidBesideTest, AYesWithANoIsNone) {
  world.say(List{act("confirm"), act("deny")});
  EXPECT_EQ(world.said(), asked_again);
}

TEST_F(SaidBesideTest, TheSameValueIsTheSameYes) {
  world.say(List{act("confirm"), inform("Meeting", {{"Host", "Ann Lee"}})});
  EXPECT_EQ(world.said(), (Texts{"Host Ann Lee.", "From?"}));
}

TEST_F(SaidBesideTest, AnotherValueComesBeforeTheAnswer) {
  world.say(List{act("confirm"), inform("Meeting", {{"Host", "Bob Lee"}})});
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Bob Lee, type: set}]"});
}

TEST_F(SaidBesideTest, ThanksLeaveAYesAsItIs) {
  world.say(List{act("confirm"), act("thank")});
  EXPECT_EQ(world.said().front(), "Host Ann Lee.");
}

} // namespace
} // namespace parlour::dialogue
