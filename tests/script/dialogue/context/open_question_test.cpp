// The question that waits, and whether its words were heard (engine rule 3).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(OpenQuestion, ASecondTurnInTheMailboxWithdrawsTheQuestion) {
  World world(booking);
  world.queue(inform("Booking", {{"Place", "Hall"}}));
  world.queue(inform("Booking", {{"Time", "10:30"}}));
  world.run();
  EXPECT_EQ(world.said(), (Texts{"Started.", "Place Hall.", "Time 10:30.",
                                 "Filled.", "Completed."}));
}

TEST(OpenQuestion, AWithdrawnQuestionIsNoAsking) {
  World world(booking);
  world.queue(inform("Booking", {}));
  world.queue(Map{{"act", "nonsense"}});
  world.run();
  // The first wording: that it was due before does not count.
  EXPECT_EQ(world.said(), (Texts{"Started.", "[no_match]", "Where?"}));
}

} // namespace
} // namespace parlour::dialogue
