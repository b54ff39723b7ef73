// Which topic an act goes to (engine rule 5, "Acts").
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(TopicActs, AYesThatNobodyAskedForIsAcknowledged) {
  World world(booking);
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"[acknowledge]"});
}

TEST(TopicActs, UnregisteredTopicsTakeNoPart) {
  World world(std::string(booking) + R"xml(
    <handler name="H"><messages><component>
      <Door><Shut><unregister topic="Taxi"/></Shut>
        <Opened><register topic="Taxi"/></Opened></Door>
    </component></messages></handler>)xml");
  world.components["Door"] = {};
  world.event("Door", "Shut");
  world.say(inform("Taxi", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
  world.event("Door", "Opened");
  world.say(inform("Taxi", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
}

// "The nights": to be another number of them.
Value naming(const char* slot) {
  return Map{{"topic", "Room"},
             {"act", "correct"},
             {"slots", Map{{slot, Map{{"unmatched", true}, {"text", slot}}}}}};
}

constexpr const char* room = R"xml(
  <topic name="Room" confirm="summary">
    <slot name="Nights" type="Functional" question="How many nights?"
          label="nights"/>
    <slot name="Name" type="Functional" question="Who?" label="name"/>
    <completed><speak param="Booked {this.Nights} for {this.Name}."/></completed>
  </topic>)xml";

TEST(TopicActs, ASlotThatIsNamedIsAskedForAgain) {
  World world(room);
  world.say(inform("Room", {{"Nights", "2"}, {"Name", "Ann"}}));
  world.said();
  world.say("deny"); // what is to be changed?
  world.said();
  world.say(naming("Name"));
  EXPECT_EQ(world.said(), Texts{"Who?"});
  world.say("confirm"); // of nothing
  EXPECT_EQ(world.said(), Texts{"Who?"});
  world.say(inform("Room", {{"Name", "Ben"}}));
  EXPECT_EQ(world.said().size(), 1U); // the summary
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Booked 2 for Ben."});
}

TEST(TopicActs, ASlotMayBeNamedToTheSummaryItself) {
  World world(room);
  world.say(inform("Room", {{"Nights", "2"}, {"Name", "Ann"}}));
  world.said();
  world.say(naming("Nights"));
  EXPECT_EQ(world.said(), Texts{"How many nights?"});
  world.say(inform("Room", {{"Nights", "3"}}));
  EXPECT_EQ(world.said().size(), 1U);
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Booked 3 for Ann."});
}

TEST(TopicActs, ASlotIsNamedInVainWhereNobodyAskedWhatIsWrong) {
  World world(room);
  world.say(inform("Room", {{"Nights", "2"}}));
  EXPECT_EQ(world.said(), Texts{"Who?"});
  world.say(naming("Nights"));
  EXPECT_EQ(world.said(), Texts{"Who?"});
  EXPECT_EQ(world.slot("Room", "Nights"), Value("2"));
}

// "Cancel the room for two nights" begins no booking.
TEST(TopicActs, ACancelWithValuesIsACancel) {
  World world(room);
  const auto cancel = [&] {
    world.say(Map{
        {"topic", "Room"}, {"act", "cancel"}, {"slots", Map{{"Nights", "2"}}}});
    return world.said();
  };
  EXPECT_EQ(cancel(), Texts{"[cancelled]"});
  world.say(inform("Room", {{"Nights", "2"}}));
  EXPECT_EQ(world.said(), Texts{"Who?"});
  EXPECT_EQ(cancel(), Texts{"[cancelled Room]"});
}

} // namespace
} // namespace parlour::dialogue
