// Questions of scripts, and what they read and write of topics.
#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/topic_effects.hpp"
#include "tests/script/dialogue/bell.hpp"
#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(TopicEffects, ConfirmYesAndNo) {
  for (bool yes : {true, false}) {
    Bell world("<speak param='Bell.'/>", transfer);
    world.say(inform("Transfer", {{"Host", "Ann"}}));
    EXPECT_EQ(world.said(), Texts{"Call Ann?"});
    world.ring(); // the pipeline keeps running
    EXPECT_EQ(world.said(), Texts{"Bell."});
    world.say(yes ? "confirm" : "deny");
    EXPECT_EQ(world.said(), yes ? (Texts{"Calling.", "Why?"})
                                : (Texts{"Not calling.", "Whom?"}));
  }
}

TEST(TopicEffects, CancelEndsAConfirm) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.said();
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"Cancelled.", "[cancelled Transfer]"}));
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"[acknowledge]"});
}

TEST(TopicEffects, AConfirmIsAskedAgainAfterAnotherTopic) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.said();
  world.say(inform("Hours", {{"Day", "Monday"}}));
  EXPECT_EQ(world.said(), Texts{"[confirm Hours.Day {value: Monday}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Nine."});
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Calling.", "Why?"}));
}

TEST(TopicEffects, AYesAfterAnotherTopicIsAskedForAgain) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.say(inform("Hours", {{"Day", slot_value("Monday", 1)}}));
  world.say("confirm");
  world.said();
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Calling.", "Why?"}));
}

TEST(TopicEffects, WhatElseWasSaidDoesNotWaitForAConfirm) {
  Bell world("", transfer);
  world.say(List{inform("Transfer", {{"Host", "Ann"}}),
                 inform("Hours", {{"Day", slot_value("Monday", 1)}})});
  EXPECT_EQ(world.said(), Texts{"[confirm Hours.Day {value: Monday}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Nine."});
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"Call Ann?"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Calling.", "Why?"}));
}

TEST(TopicEffects, AYesThatNamesATopicIsForItsConfirm) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.say(inform("Hours", {{"Day", "Monday"}}));
  world.said(); // the day is to be confirmed, too
  world.say(act("confirm", "Transfer"));
  EXPECT_EQ(world.said(), (Texts{"Calling.", "Why?"}));
  EXPECT_EQ(world.conversation->current_topic(), "Transfer");
}

TEST(TopicEffects, AConfirmThatIsCancelledIsNoError) {
  Bell world("<confirm question='Open?'/><speak param='Never.'/>");
  world.ring();
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"Open?", "[cancelled]"}));
  EXPECT_EQ(world.seen(InspectionKind::error), Texts{});
  EXPECT_EQ(world.seen(InspectionKind::log), Texts{});
  EXPECT_EQ(world.seen(InspectionKind::cancelled).size(), 1u);
}

TEST(TopicEffects, AConfirmRepeatedInSilenceEndsSomewhere) {
  Bell world("", transfer);
  world.say(inform("Transfer", {{"Host", "Ann"}}));
  world.advance(10min);
  EXPECT_TRUE(world.has_ended);
  auto said = world.said();
  EXPECT_EQ(said.size(), 7u); // asked, five times again, cancelled
  EXPECT_EQ(said.back(), "Cancelled.");
}

TEST(TopicEffects, PrivateSlotsAreMasked) {
  World world(R"xml(<topic name="T"><slot name="Pin" private="true"/>
    <slot name="Free"/></topic>)xml");
  world.say(inform("T", {{"Pin", 4711}, {"Free", 12}}));
  EXPECT_EQ(world.seen(InspectionKind::slot),
            (Texts{"T.Pin: *** (accepted)", "T.Free: 12 (accepted)"}));
}

TEST(TopicEffects, SetChangesASlotAndUnknownSlotsAreErrors) {
  Bell world("", R"xml(<topic name="T"><slot name="A"/><slot name="B">
      <filled><set name="this.A" expr="this.B + 1"/></filled></slot></topic>
    )xml");
  world.say(inform("T", {{"B", 1}}));
  EXPECT_EQ(world.slot("T", "A"), 2);
}

} // namespace
} // namespace parlour::dialogue
