// The pipeline lane: handlers of messages (engine rules 1d and 2).
#include <gtest/gtest.h>

#include "script/dialogue/engine/pipeline.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

struct Bells : World {
  explicit Bells(const std::string& script) : World(script) {
    components["Bell"] = {};
    components["Door"] = {};
  }
};

std::string handler(const char* name, const std::string& events) {
  return std::string("<handler name=\"") + name +
         "\"><messages><component><Bell>" + events +
         "</Bell></component></messages></handler>";
}

TEST(Pipeline, HandlersInFileOrderUntilConsumed) {
  Bells world(handler("A", "<Rings><speak param='A'/></Rings>") +
              handler("B", "<Rings><speak param='B'/><consume/></Rings>") +
              handler("C", "<Rings><speak param='C'/></Rings>"));
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), (Texts{"A", "B"}));
}

TEST(Pipeline, RegisteredAndNot) {
  Bells world(handler("A", "<Rings><speak param='A'/></Rings>") +
              handler("B", "<Off><unregister handler='A'/></Off>"
                           "<On><register handler='A'/></On>"));
  world.event("Bell", "Off");
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{});
  world.event("Bell", "On");
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{"A"});
}

TEST(Pipeline, WhatNobodyTakesIsCounted) {
  Bells world("");
  world.event("Bell", "Rings");
  EXPECT_EQ(world.seen(InspectionKind::unhandled).size(), 1u);
}

TEST(Pipeline, AWaitHoldsOnlyItsOwnKind) {
  Bells world(handler("A", "<Rings><wait for='5s'/><speak param='{_LPARAM1}'/>"
                           "</Rings><Stops><speak param='Stop.'/></Stops>"));
  world.event("Bell", "Rings", {1});
  world.event("Bell", "Rings", {2});
  world.event("Bell", "Stops");
  EXPECT_EQ(world.said(), Texts{"Stop."});
  world.advance(5s);
  EXPECT_EQ(world.said(), Texts{"1"});
  world.advance(5s);
  EXPECT_EQ(world.said(), Texts{"2"});
}

TEST(Pipeline, ManyHeldMessagesAreNotScriptsChasingEachOther) {
  Bells world(handler("A", "<Rings><if cond='_LPARAM1 == 0'><wait for='5s'/>"
                           "</if><speak param='{_LPARAM1}'/></Rings>"));
  for (int i = 0; i < 101; ++i)
    world.event("Bell", "Rings", {i});
  world.advance(5s);
  EXPECT_EQ(world.said().size(), 101u);
  EXPECT_EQ(world.seen(InspectionKind::error), Texts{});
}

TEST(Pipeline, HoldsNoMoreThanItsLimit) {
  Bells world(handler("A", "<Rings><if cond='_LPARAM1 == 0'><wait for='5s'/>"
                           "</if><speak param='{_LPARAM1}'/></Rings>"));
  for (int i = 0; i < 103; ++i)
    world.event("Bell", "Rings", {i});
  const auto errors = world.seen(InspectionKind::error);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0], "Limit: more than 100 messages Bell.Rings wait behind a "
                       "handler that waits; this one is dropped");
  EXPECT_EQ(world.said().size(), 1u); // the apology
  world.advance(5s);
  EXPECT_EQ(world.said().size(), 101u);
}

// Who handles errors hears of the first.
TEST(Pipeline, TooManyHeldAreOneError) {
  Bells world(handler("A", "<Rings><wait for='5s'/></Rings>") + R"xml(
    <handler name="E"><messages><component><Script><Error>
      <speak param="{_LPARAM1}"/></Error></Script></component></messages>
    </handler>)xml");
  for (int i = 0; i < 200; ++i)
    world.event("Bell", "Rings", {i});
  EXPECT_EQ(world.said(), Texts{"more than 100 messages Bell.Rings wait behind "
                                "a handler that waits; this one is dropped"});
}

TEST(Pipeline, WhatTheEngineRaisesNeedNotBeTaken) {
  Bells world(handler("A", "<Rings><fire event='Heard'/></Rings>"));
  world.event("Bell", "Rings");
  EXPECT_EQ(world.seen(InspectionKind::unhandled), Texts{});
  world.event("Knowledge", "Result"); // a component of that name
  EXPECT_EQ(world.seen(InspectionKind::unhandled).size(), 1u);
}

TEST(Pipeline, ConfirmInAHandlerWaitsWhileOthersRun) {
  Bells world(handler(
      "A", "<Rings><confirm question='Open?'><yes><speak param='Open.'/>"
           "</yes><no><speak param='Shut.'/></no></confirm></Rings>"
           "<Stops><speak param='Stop.'/></Stops>"));
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{"Open?"});
  world.event("Bell", "Stops");
  EXPECT_EQ(world.said(), Texts{"Stop."});
  world.say("confirm");
  EXPECT_EQ(world.said(), Texts{"Open."});
}

TEST(Pipeline, PushInAHandlerComesBackToIt) {
  Bells world("<state name='Sub'><Exit><speak param='Out.'/></Exit><Messages>"
              "<component><Bell><Done><pop/></Done></Bell></component>"
              "</Messages></state>" +
              handler("A", "<Rings><push state='Sub'/><speak param='Back.'/>"
                           "</Rings>"));
  world.event("Bell", "Rings");
  EXPECT_EQ(world.conversation->state(), "Sub");
  world.event("Bell", "Done");
  EXPECT_EQ(world.said(), (Texts{"Out.", "Back."}));
}

TEST(Pipeline, NothingUnderstoodCountsOnTheQuestion) {
  Bells world("<topic name='T'><slot name='S' type='Functional' question='S?'>"
              "<help><value>Which S?</value></help></slot></topic>");
  world.components["Grammar"] = {"NLU"};
  world.event("Grammar", "NoResult", {"hm"});
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
  world.say(inform("T", {}));
  EXPECT_EQ(world.said(), Texts{"S?"});
  world.event("Grammar", "NoResult", {"hm"});
  EXPECT_EQ(world.said(), Texts{"S?"});
  world.event("Grammar", "NoResult", {"hm"});
  EXPECT_EQ(world.said(), Texts{"Which S?"});
}

// An application whose understanding is asked and does not answer by itself.
struct Understood : World {
  Understood()
      : World(R"xml(<handler name="U"><messages><component><ASR>
          <RecognitionResult><post module="NLU" command="DoNLU"
            param="_LPARAM1"/><consume/></RecognitionResult>
          </ASR></component></messages></handler>)xml") {
    components["Grammar"] = {"NLU"};
    event("ASR", "RecognitionResult", {"well"});
  }
};

TEST(Pipeline, AnUnderstandingThatBreaksLeavesNoTurnWithoutAWord) {
  Understood world;
  EXPECT_EQ(world.said(), Texts{});
  world.event("Grammar", "Failed", {"oh"}, world.messages.back().correlation);
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
  world.advance(10s);
  EXPECT_EQ(world.said(), Texts{});
}

TEST(Pipeline, NeitherDoesOneThatNeverAnswers) {
  Understood world;
  world.advance(10s);
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
}

TEST(Pipeline, ActsAreMessagesOfTheDialogue) {
  Bells world(R"xml(
    <topic name="T"><slot name="S" type="Functional"/>
      <completed><speak param="Topic."/></completed></topic>
    <handler name="H"><messages><component><Dialogue><inform>
      <speak param="Heard {_LPARAM1.slots.S}."/>
      <if cond="_LPARAM1.slots.S == 2"><consume/></if>
    </inform></Dialogue></component></messages></handler>)xml");
  world.say(inform("T", {{"S", 1}}));
  EXPECT_EQ(world.said(), (Texts{"Heard 1.", "Topic."}));
  world.say(inform("T", {{"S", 2}}));
  EXPECT_EQ(world.said(), Texts{"Heard 2."});
}

constexpr const char* holds_the_lane = R"xml(
  <topic name="T">
    <slot name="S" type="Functional" question="What?"/>
    <filled><request module="Slow" command="Go"/></filled>
    <completed><speak param="Done."/></completed>
  </topic>)xml";

TEST(Pipeline, WhatTheUserSaysWaitsForWhatHoldsTheDialogueLane) {
  World world(holds_the_lane);
  world.components["Slow"] = {};
  world.say(inform("T", Map{{"S", "a"}}));
  world.said();
  world.say(inform("T", Map{{"S", "b"}}));
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_EQ(world.slot("T", "S"), "a");
}

TEST(Pipeline, WhoWantsOutDoesNotWaitForIt) {
  World world(holds_the_lane);
  world.components["Slow"] = {};
  world.say(inform("T", Map{{"S", "a"}}));
  world.said();
  world.say("cancel");
  EXPECT_EQ(world.conversation->current_topic(), "");
  EXPECT_TRUE(world.slot("T", "S").is_unknown());
}

} // namespace
} // namespace parlour::dialogue
