// Which grammar the recogniser is told of (language rule 12.18).
#include <gmock/gmock.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* shop = R"xml(
    <grammar name="wares">public &lt;w> = tea | coffee;</grammar>
    <grammar name="size">public &lt;s> = small | large;</grammar>
    <state name="Shop" grammar="wares"><Messages><component><Bell>
      <Stops><transit state="Street"/></Stops>
    </Bell></component></Messages></state>
    <state name="Street"/>
    <topic name="Order">
      <slot name="Size" type="Functional" question="Large?" grammar="size"/>
    </topic>)xml";

class HeardGrammarTest : public testing::Test {
protected:
  // What the recogniser was told since the last call.
  std::vector<std::string> told(World& world) {
    std::vector<std::string> names;
    for (; seen_ < world.messages.size(); ++seen_)
      if (const auto& each = world.messages[seen_];
          each.command == "SetGrammar") {
        EXPECT_THAT(each.sinks, ElementsAre("ASR"));
        names.push_back(to_string(each.params.at(0)));
      }
    return names;
  }
  static WorldOptions in_shop() {
    WorldOptions options;
    options.start = "Shop";
    return options;
  }

private:
  std::size_t seen_ = 0;
};

TEST_F(HeardGrammarTest, IsTheQuestionsOrTheStates) {
  World world(shop, in_shop());
  world.event("Bell", "Rings");
  EXPECT_THAT(told(world), ElementsAre("[wares]"));
  world.event("Bell", "Rings");
  EXPECT_THAT(told(world), IsEmpty());
  world.say(inform("Order", {}));
  EXPECT_THAT(told(world), ElementsAre("[size]"));
  world.say("cancel");
  EXPECT_THAT(told(world), ElementsAre("[wares]"));
  world.event("Bell", "Stops");
  EXPECT_THAT(told(world), ElementsAre("[]"));
}

TEST_F(HeardGrammarTest, IsNotToldWithoutARecogniserOrGrammars) {
  auto options = in_shop();
  options.open = false;
  World deaf(shop, options);
  deaf.components.clear();
  deaf.open();
  EXPECT_THAT(told(deaf), IsEmpty());
  World any("<state name='Shop'/>", in_shop());
  any.event("Bell", "Rings");
  EXPECT_THAT(deaf.messages, IsEmpty());
  EXPECT_THAT(any.messages, IsEmpty());
}

} // namespace
} // namespace parlour::dialogue
