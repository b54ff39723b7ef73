// Which topic is the current one (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(TopicChanges, SuspendedTwoDeepAndBack) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.say(inform("Taxi", {}));
  world.say(inform("Weather", {{"Day", "Monday"}}));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Place Hall.", "When?",
                                 "Suspended.", "Which street?", "Sunny."}));
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"Which street?"});
  world.say(inform({}, {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
  world.advance(2s);
  EXPECT_EQ(world.said(), (Texts{"Resumed.", "When?"}));
  world.say(inform({}, {{"Time", "9:15"}}));
  EXPECT_EQ(world.said(), (Texts{"Time 09:15.", "Filled.", "Completed."}));
  EXPECT_FALSE(world.has_ended);
}

TEST(TopicChanges, NeedsComeFirstAndGoBack) {
  World world(R"xml(
    <topic name="Visitor"><slot name="Name" type="Functional"
      question="Your name?"/></topic>
    <topic name="Parcel" needs="Visitor"><slot name="Size" type="Functional"
      question="Which size?"/>
      <completed><speak param="Sent."/></completed></topic>)xml");
  world.say(inform("Parcel", {}));
  EXPECT_EQ(world.said(), Texts{"Your name?"});
  world.say(inform({}, {{"Name", "Ann"}}));
  EXPECT_EQ(world.said(), Texts{"Which size?"});
  world.say(inform({}, {{"Size", "small"}}));
  EXPECT_EQ(world.said(), Texts{"Sent."});
}

} // namespace
} // namespace parlour::dialogue
