// Who wants out ends what scripts wait for (engine rule 2.5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(WaitEnds, AScriptThatWaitsForAYesHearsThatItIsCancelled) {
  World world(transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"Cancelled.", "[cancelled Transfer]"}));
}

} // namespace
} // namespace parlour::dialogue
