// <confirm>s of scripts that wait for an answer (language rule 12.20).
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* order = R"xml(
  <topic name="Order"><slot name="Dish" type="Functional"
    question="Which dish?" confirm="never"/>
    <filled><confirm question="{this.Dish}?">
      <yes><speak param="Yes."/></yes>
      <no><speak param="Then not."/></no></confirm></filled>
    <completed><speak param="Done."/></completed></topic>)xml";

TEST(Confirmations, AreAskedAnewWhereAnotherValueIsSaid) {
  World world(order);
  world.say(inform("Order", {{"Dish", "Soup"}}));
  EXPECT_EQ(world.said(), Texts{"Soup?"});
  world.say(act("correct", {}, {{"Dish", "Rice"}}));
  EXPECT_EQ(world.said(), Texts{"Rice?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Yes.", "Done."}));
}

TEST(Confirmations, EndWithTheirTopic) {
  World world(order);
  world.say(inform("Order", {{"Dish", "Soup"}}));
  world.said();
  world.say("cancel");
  EXPECT_EQ(world.said(), Texts{"[cancelled Order]"});
  world.say("confirm"); // of what?
  EXPECT_EQ(world.said(), Texts{"[acknowledge]"});
}

} // namespace
} // namespace parlour::dialogue
