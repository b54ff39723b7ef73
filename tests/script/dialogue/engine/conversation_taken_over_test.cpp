// Conversations that go on with another script (engine rule 7.12).
#include <gtest/gtest.h>

#include "script/dialogue/engine/conversation.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

const std::string taxi = R"(
  <topic name="Taxi">
    <slot name="Where" type="Functional" question="Where to?"/>
    <slot name="When" type="Functional" question="When?">
      <cardinality type="time"/></slot>
    <filled><speak param="To {this.Where} at {this.When}."/></filled>
  </topic>)";

TEST(ConversationTakenOver, GoesOnWhereItWas) {
  World world(taxi);
  world.say(inform("Taxi", {{"Where", "Sentosa"}}));
  EXPECT_EQ(world.said(), Texts{"When?"});
  EXPECT_EQ(world.change_script(R"(
    <topic name="Shops"><slot name="Kind" question="Which?"/></topic>
    <topic name="Taxi">
      <slot name="When" type="Functional" question="When?">
        <cardinality type="time"/></slot>
      <slot name="Where" type="Functional" question="Where to?"/>
      <filled><speak param="A taxi to {this.Where}, {this.When}."/></filled>
    </topic>)"),
            Texts{});
  world.say(inform({}, {{"When", "10:30"}}));
  EXPECT_EQ(world.said(), Texts{"A taxi to Sentosa, 10:30."});
}

TEST(ConversationTakenOver, TheSameScriptChangesNothing) {
  World one(taxi), other(taxi);
  for (auto* world : {&one, &other})
    world->say(inform("Taxi", {{"Where", "Sentosa"}}));
  EXPECT_EQ(one.change_script(taxi), Texts{});
  for (auto* world : {&one, &other}) {
    world->say("help");
    world->advance(20s);
    world->say("repeat");
    world->say(inform("Taxi", {{"When", "noon"}}));
    world->advance(20s);
  }
  EXPECT_EQ(one.said(), other.said());
  other.repeats = false;
}

TEST(ConversationTakenOver, ValuesAreCheckedAgain) {
  World world(taxi);
  world.say(inform("Taxi", {{"Where", "Sentosa"}}));
  EXPECT_EQ(world.change_script(R"(
    <topic name="Taxi">
      <slot name="Where" type="Functional" question="To which airport?">
        <cardinality type="set"><value>Changi</value><value>Seletar</value>
        </cardinality></slot>
      <filled><speak param="To {this.Where}."/></filled>
    </topic>)"),
            Texts({"the value of the slot 'Taxi.Where'",
                   "the question that waited for an answer"}));
  EXPECT_TRUE(world.slot("Taxi", "Where").is_unknown());
  world.said();
  world.advance(20s);
  EXPECT_EQ(world.said().front(), "To which airport?");
}

TEST(ConversationTakenOver, ConstraintsHoldForThem) {
  World world(taxi);
  world.say(inform("Taxi", {{"Where", "Sentosa"}}));
  EXPECT_EQ(world.change_script(R"(
    <topic name="Taxi">
      <slot name="Where" type="Functional" question="Where to?"/>
      <slot name="When" type="Functional" question="When?">
        <cardinality type="time"/></slot>
      <constraint cond="this.Where != 'Sentosa'" message="Not there."/>
    </topic>)"),
            Texts{"the value of the slot 'Taxi.Where'"});
  EXPECT_TRUE(world.slot("Taxi", "Where").is_unknown());
}

TEST(ConversationTakenOver, VariablesGoByTheirNames) {
  World world(R"(
    <var name="count" expr="1"/><var name="gone" expr="2"/>
    <handler name="Bell"><messages><component><Bell><Rings>
      <set name="count" expr="count + 1"/>
    </Rings></Bell></component></messages></handler>)");
  world.event("Bell", "Rings");
  EXPECT_EQ(world.change_script(R"(
    <var name="fresh" expr="7"/><var name="count" expr="100"/>
    <handler name="Bell"><messages><component><Bell><Rings>
      <speak param="{count} and {fresh}"/>
    </Rings></Bell></component></messages></handler>)"),
            Texts{"the variable 'gone'"});
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{"2 and 7"});
}

const std::string states = R"(
  <handler name="Bell"><messages><component><Bell>
    <First><transit state="Second"/></First>
    <Deeper><push state="Third"/></Deeper>
  </Bell></component></messages></handler>
  <state name="First"><Entrance><speak param="First."/></Entrance></state>
  <state name="Second"><Entrance><speak param="Second."/></Entrance></state>
  <state name="Third"><Entrance><speak param="Third."/></Entrance></state>)";

WorldOptions from(const char* start) {
  WorldOptions options;
  options.start = start;
  return options;
}

TEST(ConversationTakenOver, AStateThatIsThereIsNotEnteredAgain) {
  World world(states, from("First"));
  world.event("Bell", "First");
  world.said();
  EXPECT_EQ(world.change_script(states, from("First")), Texts{});
  EXPECT_EQ(world.conversation->state(), "Second");
  EXPECT_EQ(world.said(), Texts{});
}

TEST(ConversationTakenOver, WithoutItsStateItBegins) {
  World world(states, from("First"));
  world.event("Bell", "First");
  world.said();
  EXPECT_EQ(world.change_script(R"(
    <state name="First"><Entrance><speak param="Welcome back."/></Entrance>
    </state>)",
                                from("First")),
            Texts{"the state 'Second'"});
  EXPECT_EQ(world.conversation->state(), "First");
  EXPECT_EQ(world.said(), Texts{"Welcome back."});
}

TEST(ConversationTakenOver, APushedStateThatIsGoneFallsBack) {
  World world(states, from("First"));
  world.event("Bell", "Deeper");
  EXPECT_FALSE(world.conversation->is_at_rest(world.now));
  world.repeats = false; // it is no input of the world's
  world.conversation->end_scripts(world.now);
  world.run();
  world.said();
  EXPECT_EQ(world.change_script(R"(
    <state name="First"><Entrance><speak param="Welcome back."/></Entrance>
    </state>)",
                                from("First")),
            Texts{"the state 'Third'"});
  EXPECT_EQ(world.conversation->state(), "First");
  EXPECT_EQ(world.said(), Texts{});
}

const std::string knocks = R"(
  <handler name="Bell"><messages><component><Bell><Rings>
    <timer name="knock" after="3s"><speak param="Knock."/></timer>
    <timer name="gone" after="3s"><speak param="Gone."/></timer>
  </Rings></Bell></component></messages></handler>)";

TEST(ConversationTakenOver, TimersRingByTheirNames) {
  World world(knocks);
  world.event("Bell", "Rings");
  world.advance(2s);
  EXPECT_EQ(world.change_script(R"(
    <function name="later">
      <timer name="knock" after="9s"><speak param="Knock, knock."/></timer>
    </function>)"),
            Texts{"the timer 'gone'"});
  world.advance(900ms);
  EXPECT_EQ(world.said(), Texts{});
  world.advance(200ms);
  EXPECT_EQ(world.said(), Texts{"Knock, knock."});
}

TEST(ConversationTakenOver, WhatIsLostIsAnEvent) {
  World world(knocks);
  world.event("Bell", "Rings");
  world.change_script(R"(
    <handler name="Change"><messages><component><System><Reloaded>
      <speak param="Lost: {_LPARAM1}"/>
    </Reloaded></System></component></messages></handler>)");
  EXPECT_EQ(world.said(), Texts{"Lost: [the timer 'knock', the timer 'gone']"});
}

// Its timers are over, and what they were to ring is not taken for its own.
TEST(ConversationTakenOver, CanBeginInstead) {
  World world(knocks);
  world.event("Bell", "Rings");
  world.repeats = false;
  world.begin_instead(R"(
    <state name="Hall"><Entrance><speak param="Welcome."/>
      <timer name="own" after="9s"><speak param="Own."/></timer>
    </Entrance></state>)",
                      from("Hall"));
  EXPECT_EQ(world.said(), Texts{"Welcome."});
  world.advance(4s);
  EXPECT_EQ(world.said(), Texts{});
  world.advance(5s);
  EXPECT_EQ(world.said(), Texts{"Own."});
}

TEST(ConversationTakenOver, ScriptsThatWaitCanBeEnded) {
  World world(R"(
    <handler name="Bell"><messages><component><Bell><Rings>
      <try><wait for="1h"/>
      <catch name="e"><speak param="{e.kind}"/></catch></try>
    </Rings></Bell></component></messages></handler>)");
  world.event("Bell", "Rings");
  EXPECT_FALSE(world.conversation->is_at_rest(world.now));
  world.repeats = false;
  world.conversation->end_scripts(world.now);
  world.run();
  EXPECT_EQ(world.said(), Texts{"Cancelled"});
  EXPECT_TRUE(world.conversation->is_at_rest(world.now));
}

} // namespace
} // namespace parlour::dialogue
