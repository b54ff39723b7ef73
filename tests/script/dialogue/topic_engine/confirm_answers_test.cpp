// What follows the answer to a <confirm> (language rule 12.20).
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

TEST(ConfirmAnswers, AConfirmAboutASlotSettlesIt) {
  constexpr const char* order = R"xml(
    <topic name="Order"><slot name="Dish" type="Functional"
      question="Which dish?"/>
      <filled><confirm question="{this.Dish}?" slot="Dish">
        <yes><speak param="Yes, {this.Dish}."/></yes>
        <no><speak param="Then not."/></no></confirm></filled>
      <completed><speak param="Done."/></completed></topic>)xml";
  World world(order);
  world.say(inform("Order", {{"Dish", "Soup"}}));
  EXPECT_EQ(world.said(), Texts{"Soup?"});
  world.say("deny");
  EXPECT_EQ(world.slot("Order", "Dish"), Value());
  EXPECT_EQ(world.said(), (Texts{"Then not.", "Which dish?"}));
  world.say(inform({}, {{"Dish", "Rice"}}));
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Rice?", "Yes, Rice.", "Done."}));
}

} // namespace
} // namespace parlour::dialogue
