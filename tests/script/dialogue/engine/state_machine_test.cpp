// States: transitions, push and pop, capture (engine rules 2 and 4).
#include <gtest/gtest.h>

#include "script/dialogue/engine/state_machine.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

WorldOptions starting_in(const char* state) {
  WorldOptions options;
  options.start = state;
  return options;
}

constexpr const char* rooms = R"xml(
  <function name="go"><transit state="C"/></function>
  <state name="A">
    <Entrance><speak param="In A."/></Entrance>
    <Exit><speak param="Out of A."/></Exit>
    <Messages><component><Bell>
      <ToB><transit state="B"><speak param="On the way."/></transit></ToB>
      <Twice><transit state="B"><speak param="No."/></transit>
        <transit state="C"><speak param="Yes."/></transit>
        <speak param="Still here."/></Twice>
      <Call><call function="go"/></Call>
      <Sub><var name="n" expr="1"/><push state="Sub"/>
        <speak param="Back {n} in {_STATE}."/></Sub>
      <Chase><transit state="X"/></Chase>
    </Bell></component></Messages>
  </state>
  <state name="B"><Entrance><speak param="In B."/></Entrance></state>
  <state name="C"><Entrance><speak param="In {_STATE}."/></Entrance></state>
  <state name="Sub" capture="true">
    <Entrance><speak param="In Sub."/></Entrance>
    <Exit><speak param="Out of {_STATE}."/></Exit>
    <Messages><component>
      <Bell><Done><pop/></Done><Deeper><transit state="C"/></Deeper></Bell>
      <Dialogue><inform><speak param="Sub has it."/></inform></Dialogue>
    </component></Messages>
  </state>
  <state name="X"><Entrance><transit state="Y"/></Entrance></state>
  <state name="Y"><Entrance><transit state="X"/></Entrance></state>
  <topic name="Topic"><slot name="S" type="Functional"/>
    <completed><speak param="Topic has it."/></completed></topic>)xml";

struct Rooms : World {
  Rooms() : World(rooms, starting_in("A")) {
    components["Bell"] = {};
    said();
  }
  Texts ring(const char* event) {
    this->event("Bell", event);
    return said();
  }
};

TEST(StateMachine, ExitChildrenEntrance) {
  Rooms world;
  EXPECT_EQ(world.ring("ToB"), (Texts{"Out of A.", "On the way.", "In B."}));
  EXPECT_EQ(world.conversation->state(), "B");
  EXPECT_EQ(world.ring("ToB"), Texts{}); // only the active one receives
}

TEST(StateMachine, TheLastTransitCounts) {
  Rooms world;
  EXPECT_EQ(world.ring("Twice"),
            (Texts{"Still here.", "Out of A.", "Yes.", "In C."}));
}

TEST(StateMachine, WhatStandsInATransitKeepsTopicAndMessage) {
  WorldOptions options;
  options.start = "T";
  World world(R"xml(
    <state name="A"/>
    <handler name="H"><messages><component><Bell><Go><transit state="A">
      <speak param="{_SOURCE} {_LPARAM1}"/></transit></Go></Bell></component>
      </messages></handler>
    <topic name="T"><slot name="S" type="Functional" question="S?">
      <filled><transit state="A"><speak param="S is {this.S}."/></transit>
      </filled></slot></topic>)xml",
              options);
  world.components["Bell"] = {};
  world.said();
  world.say(inform("T", {{"S", 1}}));
  EXPECT_EQ(world.said(), Texts{"S is 1."});
  world.event("Bell", "Go", {"now"});
  EXPECT_EQ(world.said(), Texts{"Bell now"});
}

TEST(StateMachine, TransitInsideAFunction) {
  Rooms world;
  EXPECT_EQ(world.ring("Call"), (Texts{"Out of A.", "In C."}));
}

TEST(StateMachine, ASubtaskCapturesActsAndComesBack) {
  Rooms world;
  EXPECT_EQ(world.ring("Sub"), Texts{"In Sub."});
  EXPECT_EQ(world.conversation->state(), "Sub");
  world.say(inform("Topic", {{"S", 1}}));
  EXPECT_EQ(world.said(), Texts{"Sub has it."});
  EXPECT_EQ(world.ring("Done"), (Texts{"Out of Sub.", "Back 1 in A."}));
  EXPECT_EQ(world.conversation->state(), "A");
  world.say(inform("Topic", {{"S", 1}}));
  EXPECT_EQ(world.said(), Texts{"Topic has it."});
}

TEST(StateMachine, ATransitInASubtaskChangesThatLevel) {
  Rooms world;
  world.ring("Sub");
  EXPECT_EQ(world.ring("Deeper"), (Texts{"Out of Sub.", "In C."}));
  world.say(inform("Topic", {{"S", 1}}));
  EXPECT_EQ(world.said(), Texts{"Topic has it."}); // C captures nothing
}

TEST(StateMachine, TheSessionsEndRunsEveryExit) {
  Rooms world;
  world.ring("Sub");
  world.take(input::Closed());
  EXPECT_EQ(world.said(), (Texts{"Out of Sub.", "Out of A."}));
  EXPECT_TRUE(world.has_ended);
}

struct Leaving : World {
  Leaving()
      : World(R"xml(
    <state name="A"><Exit>
      <querydb param="SELECT 1" return="r"/><speak param="First."/>
      <wait for="2s"/><speak param="Second."/></Exit></state>
    <handler name="H"><messages><component><Session><Ended>
      <wait for="3s"/><speak param="Ended."/></Ended></Session></component>
      </messages></handler>)xml",
              starting_in("A")) {
    components["Store"] = {"Database"};
    database = [](const QueryRequest&) { return ResultSet(); };
    take(input::Closed());
    run();
  }
};

TEST(StateMachine, ExitAndSessionEndedMayWait) {
  Leaving world;
  EXPECT_EQ(world.said(), Texts{"First."});
  EXPECT_FALSE(world.has_ended);
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"Second."});
  EXPECT_FALSE(world.has_ended);
  world.advance(3s);
  EXPECT_EQ(world.said(), Texts{"Ended."});
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.timers(), 0u);
}

TEST(StateMachine, AnExitThatWaitsForeverIsEnded) {
  World world(R"xml(
    <state name="A"><Exit><wait for="1h"/><speak param="Late."/></Exit></state>
    )xml",
              starting_in("A"));
  world.take(input::Closed());
  world.run();
  EXPECT_FALSE(world.has_ended);
  world.advance(10s); // sessions request-timeout
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.said(), Texts{});
}

TEST(StateMachine, StatesThatChaseEachOtherAreStopped) {
  Rooms world;
  world.ring("Chase");
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
  EXPECT_FALSE(world.has_ended);
  world.say(inform("Topic", {{"S", 1}}));
  EXPECT_EQ(world.said(), Texts{"Topic has it."});
}

TEST(StateMachine, PushedFromATopicsAction) {
  World world(R"xml(
    <state name="Sub"><Messages><component><Bell><Done><pop/></Done></Bell>
      </component></Messages></state>
    <topic name="T"><slot name="S" type="Functional" question="S?">
      <filled><push state="Sub"/><speak param="Back."/></filled></slot>
      <slot name="R" type="Functional" question="R?"/></topic>)xml");
  world.components["Bell"] = {};
  world.say(inform("T", {{"S", 1}}));
  EXPECT_EQ(world.conversation->state(), "Sub");
  world.advance(20s);
  EXPECT_EQ(world.said(), Texts{}); // the topic asks nothing meanwhile
  world.event("Bell", "Done");
  EXPECT_EQ(world.said(), (Texts{"Back.", "R?"}));
}

TEST(StateMachine, CancelEndsASubtask) {
  World world(R"xml(
    <state name="Sub"/>
    <topic name="T"><slot name="S" type="Functional">
      <filled><try><push state="Sub"/><catch name="e">
        <speak param="{e.kind}"/></catch></try></filled></slot>
      <slot name="R" type="Functional"/></topic>)xml");
  world.say(inform("T", {{"S", 1}}));
  EXPECT_EQ(world.conversation->state(), "Sub");
  world.say("cancel");
  EXPECT_EQ(world.said(), (Texts{"Cancelled", "[cancelled T]"}));
  EXPECT_EQ(world.conversation->state(), "");
}

TEST(StateMachine, CaptureAllKeepsEverythingFromHandlers) {
  World world(R"xml(
    <state name="Closed" capture="all"><Messages><component>
      <Bell><Open><transit state="Open"/></Open></Bell>
      </component></Messages></state>
    <state name="Open"/>
    <handler name="H"><messages><component>
      <Bell><Knock><speak param="Come in."/></Knock></Bell>
    </component></messages></handler>)xml",
              starting_in("Closed"));
  world.components["Bell"] = {};
  world.event("Bell", "Knock");
  EXPECT_EQ(world.said(), Texts{});
  world.event("Bell", "Open");
  world.event("Bell", "Knock");
  EXPECT_EQ(world.said(), Texts{"Come in."});
}

} // namespace
} // namespace parlour::dialogue
