// Topics that are cancelled (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(TopicEnds, CancelForgetsTheTopic) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"[cancelled Booking]", "Cancelled."}));
  EXPECT_EQ(world.slot("Booking", "Place"), Value());
  world.advance(10s);
  EXPECT_EQ(world.said(), Texts{});
  world.say("cancel"); // nothing is there to be cancelled
  EXPECT_EQ(world.said(), Texts{"[cancelled]"});
}

} // namespace
} // namespace parlour::dialogue
