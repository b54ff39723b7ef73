// The outcome of filling runs rules and actions (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(FillingOutcome, ConstraintsRefuseWithTheirMessage) {
  World world(meeting);
  world.say(inform("Meeting", {{"Start", 12}, {"End", 11}}));
  EXPECT_EQ(world.said().front(),
            "[invalid Meeting.Start {value: 12, reason: It must end later., "
            "type: , choices: []}]");
  EXPECT_EQ(world.slot("Meeting", "Start"), Value());
}

TEST(FillingOutcome, RulesRunWhereTheyHold) {
  World world(meeting);
  world.say(inform("Meeting", {{"Start", 9}}));
  EXPECT_EQ(world.slot("Meeting", "End"), 10);
  EXPECT_EQ(world.said(), Texts{"Whom?"});
}

} // namespace
} // namespace parlour::dialogue
