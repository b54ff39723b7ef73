// The context that the understanding gets with each DoNLU.
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* table = R"xml(
  <topic name="Table">
    <slot name="Guests" type="Functional" question="How many?" confirm="never">
      <cardinality type="number"/></slot>
    <slot name="Chairs" type="Functional" question="Chairs?" confirm="never">
      <cardinality type="number"/></slot>
    <slot name="Name" type="Functional" question="Who?" confirm="never"/>
  </topic>
  <facts name="Day"><fact day="Monday" hours="9 to 5"/></facts>
  <topic name="Hours" kind="enquiry"><slot name="Day" type="Functional"/>
    <query source="facts:Day"><by slot="Day" column="day"/></query></topic>
  <handler name="Probe"><messages><component><Bell>
    <Rings><post module="NLU" command="DoNLU" param="{'hello'}"/></Rings>
  </Bell></component></messages></handler>)xml";

class UnderstandingContext : public testing::Test {
protected:
  UnderstandingContext() {
    world.components["Grammar"] = {"NLU"};
  }
  Value context() {
    world.event("Bell", "Rings");
    return world.messages.back().params.at(1);
  }

  World world{table};
};

TEST_F(UnderstandingContext, HasWhatWasSaidBeforeTheQuestion) {
  EXPECT_TRUE(context()["said"].is_unknown());
  world.say(inform("Table", {{"Guests", 2}}));
  EXPECT_EQ(context()["asked"]["slot"], "Chairs");
  EXPECT_EQ(context()["said"], (List{"Guests"}));
}

TEST_F(UnderstandingContext, HasTheLatestLast) {
  world.say(inform("Table", {{"Chairs", 2}}));
  world.say(inform("Table", {{"Guests", 2}}));
  EXPECT_EQ(context()["asked"]["slot"], "Name");
  EXPECT_EQ(context()["said"], (List{"Chairs", "Guests"}));
  world.say(inform("Table", {{"Chairs", 3}}));
  EXPECT_EQ(context()["said"], (List{"Guests", "Chairs"}));
}

// A correction is of the answer that did not fit, not of what was before it.
TEST_F(UnderstandingContext, HasNothingBesideAnAnswerToTheQuestion) {
  world.say(inform("Table", {{"Guests", 2}}));
  world.say(inform("Table", {{"Chairs", "many"}}));
  EXPECT_EQ(context()["asked"]["slot"], "Chairs");
  EXPECT_EQ(context()["said"], List{});
}

// An enquiry in between: the question of the task waits.
TEST_F(UnderstandingContext, HasTheQuestionThatWaits) {
  world.say(inform("Table", {{"Guests", 2}}));
  EXPECT_TRUE(context()["waiting"].is_unknown());
  world.say(inform("Hours", {{"Day", "Monday"}}));
  EXPECT_TRUE(context()["asked"].is_unknown());
  EXPECT_EQ(context()["waiting"]["topic"], "Table");
  EXPECT_EQ(context()["waiting"]["slot"], "Chairs");
}

TEST_F(UnderstandingContext, ForgetsItWhenItBeginsAnew) {
  world.say(inform("Table", {{"Guests", 2}}));
  world.say("restart");
  EXPECT_TRUE(context()["said"].is_unknown());
}

// What narrows: the question's own grammar, else the state's.
TEST(UnderstandingGrammar, IsTheQuestionsOrTheStates) {
  WorldOptions options;
  options.start = "Shop";
  World world(R"xml(
    <grammar name="wares">public &lt;w> = tea | coffee;</grammar>
    <grammar name="size">public &lt;s> = small | large;</grammar>
    <state name="Shop" grammar="wares"><Messages><component><Bell>
      <Stops><transit state="Street"/></Stops>
    </Bell></component></Messages></state>
    <state name="Street"/>
    <topic name="Order">
      <slot name="What" type="Functional" question="What?"/>
      <slot name="Size" type="Functional" question="Large?" grammar="size"/>
    </topic>
    <handler name="Probe"><messages><component><Bell>
      <Rings><post module="NLU" command="DoNLU" param="{'hello'}"/></Rings>
    </Bell></component></messages></handler>)xml",
              options);
  world.components["Grammar"] = {"NLU"};
  const auto grammar = [&] {
    world.event("Bell", "Rings");
    return world.messages.back().params.at(1)["grammar"];
  };
  EXPECT_EQ(grammar(), "wares");
  world.say(inform("Order", {}));
  EXPECT_EQ(world.said(), Texts{"What?"});
  EXPECT_EQ(grammar(), "wares");
  world.say(inform("Order", {{"What", slot_value("tea", 1)}}));
  EXPECT_EQ(world.said(), Texts{"Large?"});
  EXPECT_EQ(grammar(), "size");
  world.event("Bell", "Stops");
  EXPECT_EQ(grammar(), "size");
  world.say("cancel");
  EXPECT_TRUE(grammar().is_unknown());
}

// What the slots are called, while it is asked whether they are right.
TEST(UnderstandingChanges, AreOfASummary) {
  World world(R"xml(
    <topic name="Room" confirm="summary">
      <slot name="Nights" type="Functional" question="How many?" confirm="never"
            label="nights"/>
      <slot name="Note" confirm="never"/>
      <slot name="Bed" confirm="never" if="this.Nights == '9'" label="bed"/>
    </topic>
    <handler name="Probe"><messages><component><Bell>
      <Rings><post module="NLU" command="DoNLU" param="{'hello'}"/></Rings>
    </Bell></component></messages></handler>)xml");
  world.components["Grammar"] = {"NLU"};
  const auto changes = [&] {
    world.event("Bell", "Rings");
    return world.messages.back().params.at(1)["changes"];
  };
  EXPECT_TRUE(changes().is_unknown());
  world.say(inform("Room", {{"Nights", "2"}}));
  const Value all =
      Map{{"topic", "Room"}, {"slots", Map{{"Nights", "nights"}}}};
  EXPECT_EQ(changes(), all);
  world.say("deny"); // what is to be changed?
  EXPECT_EQ(changes(), all);
}

} // namespace
} // namespace parlour::dialogue
