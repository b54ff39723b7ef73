// Corrections of what is done (engine rule 5.3).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(LateCorrections, ACorrectionIsOfWhatWasJustDone) {
  World world(booking);
  world.say(inform("Taxi", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
  world.say(act("correct", {}, {{"Street", "High"}}));
  EXPECT_EQ(world.said(), Texts{"That is already done. Shall I do it again "
                                "with this change?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
  EXPECT_EQ(world.slot("Taxi", "Street"), "High");
}

} // namespace
} // namespace parlour::dialogue
