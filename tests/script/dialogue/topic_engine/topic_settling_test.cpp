// What a filling event leads to (engine rule 5).
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* counter = R"xml(
  <facts name="Desk"><fact who="Ann" desk="7"/></facts>
  <topic name="Visitor"><slot name="Name" type="Functional"
    question="Your name?"/></topic>
  <topic name="Desk" kind="enquiry" needs="Visitor">
    <slot name="Who"/>
    <query source="facts:Desk"><by slot="Who" column="who"/></query>
    <filled><speak param="Desk {this.rows.rows[0].desk}."/></filled></topic>
  <topic name="Lunch" needs="Desk"><slot name="Dish" type="Functional"
    question="Which dish?"/></topic>)xml";

TEST(TopicSettling, AnEnquiryGoesOnWhenWhatItNeedsIsDone) {
  World world(counter);
  world.say(Map{
      {"act", "request"}, {"topic", "Desk"}, {"slots", Map{{"Who", "Ann"}}}});
  EXPECT_EQ(world.said(), Texts{"Your name?"});
  world.say(inform({}, {{"Name", "Bob"}}));
  EXPECT_EQ(world.said(), Texts{"Desk 7."});
  world.advance(20s);
  EXPECT_EQ(world.said(), Texts{}); // it rests: nothing is unfinished
}

TEST(TopicSettling, WhatNeedsAnEnquiryGoesOnWhenThatIsAnswered) {
  World world(counter);
  world.say(inform("Visitor", {{"Name", "Bob"}}));
  world.say(inform("Lunch", {}));
  EXPECT_EQ(world.said(), (Texts{"Desk 7.", "Which dish?"}));
}

TEST(TopicSettling, AConfirmAboutASlotSettlesIt) {
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

TEST(TopicSettling, AFailingConstraintIsAScriptError) {
  World world(R"xml(
    <topic name="T"><slot name="A" type="Functional" question="A?"/>
      <constraint cond="this.A / 0 gt 1" message="No."/></topic>
    <handler name="Errors"><messages><component><Script>
      <Error><speak param="{_LPARAM2}:{_LPARAM3}"/></Error>
    </Script></component></messages></handler>)xml");
  world.say(inform("T", {{"A", 3}}));
  const auto said = world.said();
  ASSERT_EQ(said.size(), 3u); // refused, asked again, told
  EXPECT_NE(said[2].find("test.xml:"), std::string::npos) << said[2];
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
}

} // namespace
} // namespace parlour::dialogue
