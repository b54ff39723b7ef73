// Yes or no: to what, and whether it counts (engine rule 5.8).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(YesOrNo, WhereNothingIsAskedItIsAcknowledged) {
  World world(meeting);
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"[acknowledge]"});
}

TEST(YesOrNo, BeforeTheQuestionWasHeardItIsNoAnswer) {
  World world(transfer);
  world.say(List{inform("Transfer", {{"Host", "Ann"}}), act("confirm")});
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("confirm");
  EXPECT_EQ(world.said().front(), "Calling.");
}

} // namespace
} // namespace parlour::dialogue
