// What silence leads to: reprompts, resumed topics, new ones (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

WorldOptions starting_with(const char* topic) {
  WorldOptions options;
  options.start = topic;
  return options;
}

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

TEST(TopicSilence, OwnWordsForSilenceAndMisunderstanding) {
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

TEST(TopicSilence, SystemInitiativeStartsByItselfAndTakesWhatItAsked) {
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

constexpr const char* resuming = R"xml(
  <topic name="Survey" resume="{policy}">
    <slot name="Answer" type="Functional" question="Which answer?"/></topic>
  <topic name="Weather"><slot name="Day" type="Functional"/></topic>)xml";

std::string with_policy(const char* policy) {
  std::string script = resuming;
  return script.replace(script.find("{policy}"), 8, policy);
}

TEST(TopicSilence, ResumeAsksFirst) {
  for (bool yes : {true, false}) {
    World world(with_policy("ask"), starting_with("Survey"));
    world.say(inform("Weather", {{"Day", "Monday"}}));
    EXPECT_EQ(world.said(), Texts{"Which answer?"});
    world.advance(2s);
    EXPECT_EQ(world.said(), Texts{"[resume Survey]"});
    world.say(yes ? "confirm" : "deny");
    EXPECT_EQ(world.said(),
              yes ? Texts{"Which answer?"} : Texts{"[cancelled Survey]"});
  }
}

TEST(TopicSilence, ResumeNever) {
  World world(with_policy("never"), starting_with("Survey"));
  world.say(inform("Weather", {{"Day", "Monday"}}));
  world.said();
  world.advance(50s);
  EXPECT_EQ(world.said(), Texts{});
}

} // namespace
} // namespace parlour::dialogue
