// Topics that run queries (engine rule 6).
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

TEST(Enquiries, AnEnquiryGoesOnWhenWhatItNeedsIsDone) {
  World world(counter);
  world.say(Map{
      {"act", "request"}, {"topic", "Desk"}, {"slots", Map{{"Who", "Ann"}}}});
  EXPECT_EQ(world.said(), Texts{"Your name?"});
  world.say(inform({}, {{"Name", "Bob"}}));
  EXPECT_EQ(world.said(), Texts{"Desk 7."});
  world.advance(20s);
  EXPECT_EQ(world.said(), Texts{}); // it rests: nothing is unfinished
}

TEST(Enquiries, WhatNeedsAnEnquiryGoesOnWhenThatIsAnswered) {
  World world(counter);
  world.say(inform("Visitor", {{"Name", "Bob"}}));
  world.say(inform("Lunch", {}));
  EXPECT_EQ(world.said(), (Texts{"Desk 7.", "Which dish?"}));
}

} // namespace
} // namespace parlour::dialogue
