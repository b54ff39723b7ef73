// A no never leads to completion (language rule 12.21).
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

TEST(Refusals, ANoOnTheWayToCompletionEndsTheTopic) {
  World world(order);
  world.say(inform("Order", {{"Dish", "Soup"}}));
  world.said();
  world.say("deny");
  EXPECT_EQ(world.said(), Texts{"Then not."});
  EXPECT_EQ(world.slot("Order", "Dish"), Value());
}

} // namespace
} // namespace parlour::dialogue
