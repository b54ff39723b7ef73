// Topics, slots and questions, told by what is said (engine rules 3, 5, 6).
#include <gtest/gtest.h>

#include "script/dialogue/topic_engine/topic_engine.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

WorldOptions starting_with(const char* topic) {
  WorldOptions options;
  options.start = topic;
  return options;
}

// A task of three slots that says what happens to it.
constexpr const char* booking = R"xml(
  <topic name="Booking">
    <slot name="Place" type="Functional" question="Where?">
      <cardinality type="set"><value>Hall</value><value>Garden</value>
      </cardinality>
      <help><value>Which place?</value></help>
      <explain><value>I need a place.</value></explain>
      <filled><speak param="Place {this.Place}."/></filled>
    </slot>
    <slot name="Time" type="Functional" question="When?">
      <cardinality type="time"/>
      <filled><speak param="Time {this.Time}."/></filled>
    </slot>
    <slot name="Name" confirm="never"/>
    <started><speak param="Started."/></started>
    <suspended><speak param="Suspended."/></suspended>
    <resumed><speak param="Resumed."/></resumed>
    <filled><speak param="Filled."/></filled>
    <completed><speak param="Completed."/></completed>
    <cancelled><speak param="Cancelled."/></cancelled>
  </topic>
  <topic name="Taxi">
    <slot name="Street" type="Functional" question="Which street?"/>
    <completed><speak param="Taxi comes."/></completed>
  </topic>
  <topic name="Weather" initiative="user">
    <slot name="Day" type="Functional"/>
    <completed><speak param="Sunny."/></completed>
  </topic>)xml";

TEST(TopicEngine, OneUtteranceFillsEverything) {
  World world(booking);
  world.say(inform("Booking", {{"Time", "10:30"}, {"Place", "Hall"}}));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Place Hall.", "Time 10:30.",
                                 "Filled.", "Completed."}));
}

TEST(TopicEngine, AsksInSlotOrderAndTakesMoreThanAskedFor) {
  World world(booking);
  world.say(inform("Booking", {{"Name", "Ann"}}));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Where?"}));
  world.say(inform({}, {{"Time", "10:30"}}));
  EXPECT_EQ(world.said(), (Texts{"Time 10:30.", "Which place?"}));
  world.say(inform({}, {{"Place", "garden"}}));
  EXPECT_EQ(world.said(), (Texts{"Place Garden.", "Filled.", "Completed."}));
}

TEST(TopicEngine, ACorrectionRunsThatSlotOnly) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say(act("correct", {}, {{"Place", "Garden"}}));
  EXPECT_EQ(world.said(), (Texts{"Place Garden.", "When?"}));
  EXPECT_EQ(world.slot("Booking", "Place"), "Garden");
}

TEST(TopicEngine, ARefusedValueLeavesTheOldOne) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say(inform("Booking", {{"Place", "Moon"}}));
  EXPECT_EQ(world.said(), (Texts{"[invalid Booking.Place {value: Moon, reason: "
                                 ", type: set, choices: [Hall, Garden]}]",
                                 "When?"}));
  EXPECT_EQ(world.slot("Booking", "Place"), "Hall");
}

TEST(TopicEngine, SuspendedTwoDeepAndBack) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.say(inform("Taxi", {}));
  world.say(inform("Weather", {{"Day", "Monday"}}));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Place Hall.", "When?",
                                 "Suspended.", "Which street?", "Sunny."}));
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"Which street?"});
  world.say(inform({}, {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
  world.advance(2s);
  EXPECT_EQ(world.said(), (Texts{"Resumed.", "When?"}));
  world.say(inform({}, {{"Time", "9:15"}}));
  EXPECT_EQ(world.said(), (Texts{"Time 09:15.", "Filled.", "Completed."}));
  EXPECT_FALSE(world.has_ended);
}

TEST(TopicEngine, CancelForgetsTheTopic) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"[cancelled Booking]", "Cancelled."}));
  EXPECT_EQ(world.slot("Booking", "Place"), Value());
  world.advance(10s);
  EXPECT_EQ(world.said(), Texts{});
  world.say("cancel"); // nothing is there to be cancelled
  EXPECT_EQ(world.said(), Texts{"[cancelled]"});
}

TEST(TopicEngine, StartOverBeginsAgain) {
  World world(booking, starting_with("Booking"));
  world.say(inform({}, {{"Place", "Hall"}}));
  world.said();
  world.say("restart");
  EXPECT_EQ(world.said(), (Texts{"[restarted]", "Started.", "Where?"}));
  EXPECT_EQ(world.slot("Booking", "Place"), Value());
}

TEST(TopicEngine, HelpExplainsAndAsksAgain) {
  World world(booking, starting_with("Booking"));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Where?"}));
  world.say("help");
  EXPECT_EQ(world.said(), (Texts{"I need a place.", "Which place?"}));
  world.say(inform({}, {{"Place", "Hall"}}));
  world.said();
  world.say("help"); // no <explain>: in general
  EXPECT_EQ(world.said().size(), 2u);
}

TEST(TopicEngine, RepeatSaysTheLastTurnOnly) {
  World world(booking);
  world.say("repeat");
  EXPECT_EQ(world.said(), Texts{"[repeat_nothing]"});
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say("repeat");
  EXPECT_EQ(world.said(), (Texts{"Started.", "Place Hall.", "When?"}));
  world.say(inform({}, {{"Time", "10:00"}}));
  world.said();
  world.say("repeat");
  EXPECT_EQ(world.said(), (Texts{"Time 10:00.", "Filled.", "Completed."}));
}

TEST(TopicEngine, GoodbyeEndsTheSessionWithSomethingUnfinished) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  world.said();
  world.say("bye");
  EXPECT_EQ(world.said(), Texts{"[bye {unfinished: [Booking]}]"});
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.timers(), 0u);
}

TEST(TopicEngine, TwoActsInOneUtterance) {
  World world(booking);
  world.say(List{inform("Booking", {{"Place", "Hall"}}),
                 inform("Weather", {{"Day", "Monday"}})});
  EXPECT_EQ(world.said(),
            (Texts{"Started.", "Place Hall.", "Suspended.", "Sunny."}));
  world.advance(2s);
  EXPECT_EQ(world.said(), (Texts{"Resumed.", "When?"}));
}

TEST(TopicEngine, ASecondTurnInTheMailboxWithdrawsTheQuestion) {
  World world(booking);
  world.queue(inform("Booking", {{"Place", "Hall"}}));
  world.queue(inform("Booking", {{"Time", "10:30"}}));
  world.run();
  EXPECT_EQ(world.said(), (Texts{"Started.", "Place Hall.", "Time 10:30.",
                                 "Filled.", "Completed."}));
}

TEST(TopicEngine, AWithdrawnQuestionIsNoAsking) {
  World world(booking);
  world.queue(inform("Booking", {}));
  world.queue(Map{{"act", "nonsense"}});
  world.run();
  // The first wording: that it was due before does not count.
  EXPECT_EQ(world.said(), (Texts{"Started.", "[no_match]", "Where?"}));
}

TEST(TopicEngine, MisunderstandingClimbsTheLadder) {
  World world(booking, starting_with("Booking"));
  world.said();
  std::vector<Texts> turns;
  for (int i = 0; i < 5; ++i) {
    world.say(inform({}, {}));
    turns.push_back(world.said());
  }
  EXPECT_EQ(turns[0], Texts{"Where?"});       // repeat
  EXPECT_EQ(turns[1], Texts{"Which place?"}); // rephrase
  EXPECT_EQ(turns[2].front(), "I need a place.");
  EXPECT_EQ(turns[3].front(),
            "[choices Booking.Place {choices: [Hall, Garden]}]");
  EXPECT_EQ(turns[4], Texts{"[person Booking.Place]"});
}

TEST(TopicEngine, SilenceClimbsItTooAndEnds) {
  World world(booking, starting_with("Booking"));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Where?"}));
  world.advance(7999ms);
  EXPECT_EQ(world.said(), Texts{});
  world.advance(1ms);
  EXPECT_EQ(world.said(), Texts{"Where?"});
  world.advance(8s);
  EXPECT_EQ(world.said(), Texts{"Which place?"});
  world.advance(10min);
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.said().back(), "[person Booking.Place]");
  EXPECT_EQ(world.timers(), 0u);
}

constexpr const char* meeting = R"xml(
  <topic name="Meeting">
    <slot name="Host" type="Functional" question="Whom?" confirm="explicit">
      <cardinality type="set"><value>Ann Lee</value><value>Bob Lee</value>
      </cardinality>
      <filled><speak param="Host {this.Host}."/></filled>
    </slot>
    <slot name="Start" type="Functional" question="From?" confirm="never"/>
    <slot name="End" type="Functional" question="To?" confirm="never"/>
    <constraint cond="this.End gt this.Start" message="It must end later."/>
    <rule if="this.Start == 9 and not this.End"><set name="this.End" expr="10"/>
    </rule>
  </topic>)xml";

TEST(TopicEngine, ExplicitConfirmationYes) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Ann Lee, type: set}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Host Ann Lee.", "From?"}));
}

TEST(TopicEngine, ExplicitConfirmationNo) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  world.said();
  world.say("deny");
  EXPECT_EQ(world.said(), Texts{"Whom?"});
  EXPECT_EQ(world.slot("Meeting", "Host"), Value());
}

TEST(TopicEngine, SilenceAfterAConfirmationAsksItAgain) {
  World world(meeting);
  world.say(inform("Meeting", {{"Host", "Ann Lee"}}));
  world.said();
  world.advance(8s);
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Ann Lee, type: set}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Host Ann Lee.", "From?"}));
}

TEST(TopicEngine, SeveralCandidatesAreAChoice) {
  World world(meeting);
  world.say(inform("Meeting",
                   {{"Host", Map{{"candidates", List{"Ann Lee", "Bob Lee"}},
                                 {"text", "Lee"}}}}));
  EXPECT_EQ(world.said(), Texts{"[ambiguous Meeting.Host {candidates: [Ann "
                                "Lee, Bob Lee], text: Lee, type: set}]"});
  world.say(inform({}, {{"Host", "Bob"}}));
  EXPECT_EQ(world.said(),
            Texts{"[confirm Meeting.Host {value: Bob Lee, type: set}]"});
}

TEST(TopicEngine, ConstraintsRefuseWithTheirMessage) {
  World world(meeting);
  world.say(inform("Meeting", {{"Start", 12}, {"End", 11}}));
  EXPECT_EQ(world.said().front(),
            "[invalid Meeting.Start {value: 12, reason: It must end later., "
            "type: , choices: []}]");
  EXPECT_EQ(world.slot("Meeting", "Start"), Value());
}

TEST(TopicEngine, RulesRunWhereTheyHold) {
  World world(meeting);
  world.say(inform("Meeting", {{"Start", 9}}));
  EXPECT_EQ(world.slot("Meeting", "End"), 10);
  EXPECT_EQ(world.said(), Texts{"Whom?"});
}

TEST(TopicEngine, ConfidenceDecidesHowSureItIs) {
  World world(booking);
  world.say(inform("Booking", {{"Place", slot_value("Hall", 0.3)}}));
  EXPECT_EQ(world.said(), (Texts{"Started.", "Where?"})); // as if not said
  world.say(inform({}, {{"Place", slot_value("Hall", 0.5)}}));
  EXPECT_EQ(world.said(),
            Texts{"[confirm Booking.Place {value: Hall, type: set}]"});
  world.say("confirm");
  EXPECT_EQ(world.said(), (Texts{"Place Hall.", "When?"}));
}

TEST(TopicEngine, NeedsComeFirstAndGoBack) {
  World world(R"xml(
    <topic name="Visitor"><slot name="Name" type="Functional"
      question="Your name?"/></topic>
    <topic name="Parcel" needs="Visitor"><slot name="Size" type="Functional"
      question="Which size?"/>
      <completed><speak param="Sent."/></completed></topic>)xml");
  world.say(inform("Parcel", {}));
  EXPECT_EQ(world.said(), Texts{"Your name?"});
  world.say(inform({}, {{"Name", "Ann"}}));
  EXPECT_EQ(world.said(), Texts{"Which size?"});
  world.say(inform({}, {{"Size", "small"}}));
  EXPECT_EQ(world.said(), Texts{"Sent."});
}

TEST(TopicEngine, FilledMayGoOnInsteadOfCompleting) {
  World world(R"xml(
    <topic name="T"><slot name="A" type="Functional" question="A?"/>
      <slot name="B" question="B?"/>
      <filled><if cond="not this.B"><ask slot="B"/></if></filled>
      <completed><speak param="Done."/></completed></topic>)xml");
  world.say(inform("T", {{"A", 1}}));
  EXPECT_EQ(world.said(), Texts{"B?"});
  world.say(inform({}, {{"B", 2}}));
  EXPECT_EQ(world.said(), Texts{"Done."});
}

TEST(TopicEngine, UnregisteredTopicsTakeNoPart) {
  World world(std::string(booking) + R"xml(
    <handler name="H"><messages><component>
      <Door><Shut><unregister topic="Taxi"/></Shut>
        <Opened><register topic="Taxi"/></Opened></Door>
    </component></messages></handler>)xml");
  world.components["Door"] = {};
  world.event("Door", "Shut");
  world.say(inform("Taxi", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
  world.event("Door", "Opened");
  world.say(inform("Taxi", {{"Street", "Main"}}));
  EXPECT_EQ(world.said(), Texts{"Taxi comes."});
}

} // namespace
} // namespace parlour::dialogue
