// What the understanding is told with each DoNLU.
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

TEST_F(UnderstandingContext, ForgetsItWhenItBeginsAnew) {
  world.say(inform("Table", {{"Guests", 2}}));
  world.say("restart");
  EXPECT_TRUE(context()["said"].is_unknown());
}

} // namespace
} // namespace parlour::dialogue
