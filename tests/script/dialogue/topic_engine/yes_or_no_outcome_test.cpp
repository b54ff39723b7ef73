// What a yes or no leads to (engine rule 5.8).
#include <gtest/gtest.h>

#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(YesOrNoOutcome, AYesAcceptsAValueInDoubt) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Ann Lee, type: set}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Host Ann Lee.", "From?"}));
}

TEST(YesOrNoOutcome, ANoTakesItBack) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  world.said();
  world.say("deny");
  EXPECT_EQ(world.said(), Texts{"Whom?"});
  EXPECT_EQ(world.slot("Meeting", "Host"), Value());
}

TEST(YesOrNoOutcome, IsTheValueOfASlotThatIsAskedFor) {
  World world(R"xml(<topic name="Room">
    <slot name="Quiet" type="Functional" question="Quiet?">
      <cardinality type="boolean"/></slot>
    <completed><speak param="{this.Quiet}"/></completed></topic>)xml");
  for (const auto& [answer, value] :
       {std::pair{"confirm", "true"}, std::pair{"deny", "false"}}) {
    world.say(inform("Room", {}));
    EXPECT_EQ(world.said(), Texts{"Quiet?"});
    world.say(answer);
    EXPECT_EQ(world.said(), Texts{value});
  }
}

TEST(YesOrNoOutcome, EndsWhatIsAskedForMore) {
  World world(R"xml(<topic name="Order">
    <slot name="Dish" type="Functional" many="true" question="What?"
          more="More?" confirm="never"/>
    <completed><speak param="{spoken(this.Dish)}"/></completed></topic>)xml");
  world.say(inform("Order", {{"Dish", "tea"}}));
  EXPECT_EQ(world.said(), Texts{"More?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"What?"});
  world.say(inform("Order", {{"Dish", "cake"}}));
  EXPECT_EQ(world.said(), Texts{"More?"});
  world.say("thank");
  EXPECT_EQ(world.said(), Texts{"one tea and one cake"});
}

} // namespace
} // namespace parlour::dialogue
