// What follows when a question is not answered (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* patient = R"xml(
  <topic name="Order">
    <slot name="Dish" type="Functional" question="Which dish?">
      <noinput count="1"><speak param="Hello?"/></noinput>
      <noinput count="2"><ask slot="Dish"/></noinput>
      <nomatch count="2"><speak param="A dish, please."/></nomatch>
      <invalid><speak param="Not on the card."/></invalid>
      <cardinality type="set"><value>Fish</value></cardinality>
    </slot>
  </topic>)xml";

TEST(Reprompts, ALadderOfTheSettingsReplacesTheStandardOne) {
  WorldOptions options;
  options.settings = R"xml(<ladder>
    <step><speak param="What? ({_SLOT})"/></step>
    <step><end/></step></ladder>)xml";
  World world(R"xml(
    <topic name="Booking"><slot name="Place" type="Functional"
      question="Where?"/></topic>)xml",
              options);
  world.say(inform("Booking", {}));
  world.said();
  world.say(act("nonsense"));
  EXPECT_EQ(world.said().front(), "What? (Place)");
  EXPECT_FALSE(world.has_ended);
  world.say(act("nonsense"));
  EXPECT_TRUE(world.has_ended);
}

TEST(Reprompts, MisunderstandingClimbsTheLadder) {
  World world(booking, starting_with("Booking"));
  world.said();
  std::vector<Texts> turns;
  for (int i = 0; i < 5; ++i) {
    world.say(inform({}, {}));
    turns.push_back(world.said());
  }
  EXPECT_EQ(turns[0], Texts{"Where?"});       // repeat
  EXPECT_EQ(turns[1], Texts{"Which place?"}); // rephrase
  EXPECT_EQ(turns[2].front(), "I need a place.");
  EXPECT_EQ(turns[3].front(),
            "[choices Booking.Place {choices: [Hall, Garden]}]");
  EXPECT_EQ(turns[4], Texts{"[person Booking.Place]"});
}

TEST(Reprompts, SilenceClimbsItTooAndEnds) {
  World world(booking, starting_with("Booking"));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Where?"}));
  world.advance(7999ms);
  EXPECT_EQ(world.said(), Texts{});
  world.advance(1ms);
  EXPECT_EQ(world.said(), Texts{"Where?"});
  world.advance(8s);
  EXPECT_EQ(world.said(), Texts{"Which place?"});
  world.advance(10min);
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.said().back(), "[person Booking.Place]");
  EXPECT_EQ(world.timers(), 0u);
}

TEST(Reprompts, OwnWordsForSilenceAndMisunderstanding) {
  World world(patient, starting_with("Order"));
  EXPECT_EQ(world.said(), Texts{"Which dish?"});
  world.advance(8s);
  EXPECT_EQ(world.said(), Texts{"Hello?"});
  world.advance(8s);
  EXPECT_EQ(world.said(), Texts{"Which dish?"});
  world.say(inform({}, {}));
  EXPECT_EQ(world.said(), Texts{"Which dish?"}); // the ladder's first
  world.say(inform({}, {}));
  EXPECT_EQ(world.said(), Texts{"A dish, please."});
  world.say(inform({}, {{"Dish", "Stone"}}));
  EXPECT_EQ(world.said(), (Texts{"Not on the card.", "A dish, please."}));
}

} // namespace
} // namespace parlour::dialogue
