// An act begins its topic, which takes what it may (engine rules 5.3 and 5.11).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(ActDelivery, TwoActsInOneUtterance) {
  World world(booking);
  world.say(List{inform("Booking", {{"Place", "Hall"}}),
                 inform("Weather", {{"Day", "Monday"}})});
  EXPECT_EQ(world.said(),
            (Texts{"Started.", "Place Hall.", "Suspended.", "Sunny."}));
  world.advance(2s);
  EXPECT_EQ(world.said(), (Texts{"Resumed.", "When?"}));
}

TEST(ActDelivery, SystemInitiativeStartsByItselfAndTakesWhatItAsked) {
  World world(R"xml(<topic name="Quiz" initiative="system">
      <slot name="First" type="Functional" question="One?" confirm="never"/>
      <slot name="Second" type="Functional" question="Two?" confirm="never"/>
      <completed><speak param="Done."/></completed></topic>
    <topic name="Next" initiative="system">
      <slot name="Third" type="Functional" question="Three?"/></topic>)xml");
  EXPECT_EQ(world.said(), Texts{"One?"});
  world.say(inform("Quiz", {{"Second", "b"}, {"First", "a"}}));
  EXPECT_EQ(world.said(), (Texts{"[one_by_one Quiz]", "Two?"}));
  EXPECT_EQ(world.slot("Quiz", "Second"), Value());
  world.say(inform("Quiz", {{"Second", "b"}}));
  EXPECT_EQ(world.said(), Texts{"Done."});
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"Three?"});
}

} // namespace
} // namespace parlour::dialogue
