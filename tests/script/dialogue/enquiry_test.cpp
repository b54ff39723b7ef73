// Enquiries: what is queried, relaxed and inherited (engine rules 5 and 6).
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* facilities = R"xml(
  <facts name="Facility">
    <fact name="Starbucks" category="coffee shop" level="1"/>
    <fact name="Ya Kun" category="coffee shop" level="1"/>
    <fact name="Food Chain" category="food court" level="-1"/>
    <fact name="City Bank" category="bank" level="1"/>
  </facts>
  <topic name="Facility" kind="enquiry">
    <slot name="Category" type="Functional" question="What do you look for?"/>
    <slot name="Level"><cardinality type="level"/></slot>
    <query source="facts:Facility">
      <by slot="Category" column="category"/>
      <by slot="Level" column="level" relax="1"/>
    </query>
    <filled>
      <var name="names" expr="[]"/>
      <for each="row" in="this.rows"><append name="names" expr="row.name"/></for>
      <speak param="{names} {this.relaxed}"/>
    </filled>
  </topic>
  <topic name="Task"><slot name="Thing" type="Functional"
    question="Which thing?"/></topic>)xml";

Value ask(Map slots, bool elliptical = false) {
  return Map{{"act", "request"},
             {"topic", "Facility"},
             {"slots", slots},
             {"elliptical", elliptical}};
}

TEST(Enquiry, AnswersFromFacts) {
  World world(facilities);
  world.say(ask({{"Category", "food court"}}));
  EXPECT_EQ(world.said(), Texts{"[Food Chain] []"});
}

TEST(Enquiry, RelaxesAndInheritsWhatWasNotRelaxed) {
  World world(facilities);
  world.say(ask({{"Category", "coffee shop"}, {"Level", 2}}));
  EXPECT_EQ(world.said(), Texts{"[Starbucks, Ya Kun] [Level]"});
  world.say(ask({{"Category", "food court"}}, true)); // anywhere
  EXPECT_EQ(world.said(), Texts{"[Food Chain] []"});
  world.say(ask({{"Category", "coffee shop"}, {"Level", 1}}));
  world.said();
  world.say(ask({{"Category", "bank"}}, true)); // on the first floor
  EXPECT_EQ(world.said(), Texts{"[City Bank] []"});
  EXPECT_EQ(world.slot("Facility", "Level"), 1);
}

TEST(Enquiry, AFullRequestBeginsWithEmptySlots) {
  World world(facilities);
  world.say(ask({{"Category", "coffee shop"}, {"Level", 1}}));
  world.say(ask({{"Category", "bank"}}));
  EXPECT_EQ(world.slot("Facility", "Level"), Value());
}

TEST(Enquiry, ContextIsForgottenInTime) {
  World world(facilities);
  world.say(ask({{"Category", "coffee shop"}, {"Level", 1}}));
  world.advance(30s);
  world.say(ask({{"Level", 1}}, true));
  EXPECT_EQ(world.said().back(), "[Starbucks, Ya Kun] []");
}

TEST(Enquiry, AsksForWhatItNeedsWhereNothingWasAskedFor) {
  World world(facilities);
  world.say(ask({}));
  EXPECT_EQ(world.said(), Texts{"What do you look for?"});
  world.say(inform({}, {{"Category", "bank"}}));
  EXPECT_EQ(world.said(), Texts{"[City Bank] []"});
  world.advance(20s);
  EXPECT_EQ(world.said(), Texts{}); // it rests: nothing is unfinished
}

TEST(Enquiry, NothingAtAllIsAnAnswerToo) {
  World world(facilities);
  world.say(ask({{"Category", "church"}}));
  EXPECT_EQ(world.said(), Texts{"[] []"});
}

TEST(Enquiry, WithoutWordsOfItsOwnTheEngineAnswers) {
  World world(R"xml(
    <facts name="Day"><fact day="Monday" hours="9 to 5"/></facts>
    <topic name="Hours" kind="enquiry"><slot name="Day" type="Functional"/>
      <query source="facts:Day"><by slot="Day" column="day"/></query></topic>
    )xml");
  world.say(inform("Hours", {{"Day", "Monday"}}));
  auto said = world.said();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].rfind("[answer Hours {rows: ", 0), 0u) << said[0];
  EXPECT_NE(said[0].find("asked: {Day: Monday}"), std::string::npos);
}

TEST(Enquiry, AnUnansweredQuestionOfItIsNotTakenUpElsewhere) {
  World world(facilities);
  world.say(ask({}));
  world.say(inform("Task", {}));
  EXPECT_EQ(world.said(), (Texts{"What do you look for?", "Which thing?"}));
  world.say(inform({}, {{"Thing", "box"}}));
  world.advance(50s);
  EXPECT_EQ(world.said(), Texts{});
}

TEST(Enquiry, AWithdrawnQuestionOfItComesBack) {
  World world(facilities);
  world.queue(ask({}));
  world.queue(Map{{"act", "nonsense"}});
  world.run();
  EXPECT_EQ(world.said(), Texts{"[no_match]"});
  world.advance(2s);
  EXPECT_EQ(world.said(), Texts{"What do you look for?"});
  world.advance(10min);
  EXPECT_TRUE(world.has_ended);
}

constexpr const char* from_database = R"xml(
  <topic name="Room" kind="enquiry"><slot name="Size" type="Functional"/>
    <query source="db" param="select name from rooms">
      <by slot="Size" column="size"/></query></topic>)xml";

TEST(Enquiry, DatabaseGone) {
  World world(from_database);
  world.database = [](const QueryRequest&) -> Expected<ResultSet> {
    return fail(ErrorKind::database, "it went away");
  };
  world.say(inform("Room", {{"Size", 9}}));
  EXPECT_EQ(world.said(), Texts{"[unavailable Room {reason: it went away, "
                                "implicit: {Size: 9}}]"});
  world.say(inform("Room", {{"Size", 9}}));
  EXPECT_EQ(world.said().size(), 1u);
}

TEST(Enquiry, AKindOfKnowledgeThatIsNotThereIsRefused) {
  World world(R"xml(
    <facts name="Chat"><fact topic="tea"/></facts>
    <topic name="Chat" kind="enquiry"><slot name="Topic"/>
      <query source="facts:Chat"><by slot="Topic" column="topic"/></query>
    </topic>)xml");
  // As from a program of a version that knows more.
  auto& program = const_cast<script::Program&>(*world.program);
  program.topics[0].queries[0].kind = "aiml";
  world.say(inform("Chat", {{"Topic", "tea"}}));
  ASSERT_EQ(world.said().size(), 1u); // unavailable
  const auto errors = world.seen(InspectionKind::error);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("<query source=\"aiml\"> is not available yet"),
            std::string::npos)
      << errors[0];
  EXPECT_NE(errors[0].find("test.xml:"), std::string::npos) << errors[0];
}

TEST(Enquiry, WhatIsNotThereIsNotLeftOutOfTheQuestion) {
  World world(facilities);
  world.say(ask({{"Category", Map{{"value", "helipad"}, {"unmatched", true}}},
                 {"Level", 1}}));
  // Category has no cardinality here: anything may be asked for.
  EXPECT_EQ(world.said(), Texts{"[] [Level]"});
  World strict(R"xml(
    <facts name="Room"><fact size="9" level="1"/></facts>
    <topic name="Room" kind="enquiry">
      <slot name="Size"><cardinality type="number"/></slot>
      <slot name="Level"><cardinality type="level"/></slot>
      <query source="facts:Room"><by slot="Size" column="size"/>
        <by slot="Level" column="level"/></query></topic>)xml");
  strict.say(inform("Room", {{"Size", "huge"}, {"Level", 1}}));
  const auto said = strict.said();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].rfind("[invalid Room.Size {value: huge", 0), 0u) << said[0];
}

TEST(Enquiry, CancelPassesTheWaitForTheDatabase) {
  World world(from_database);
  world.hold_queries = true;
  world.say(inform("Room", {{"Size", 9}}));
  EXPECT_TRUE(world.conversation->waits_for_answer());
  world.say("cancel");
  EXPECT_EQ(world.said(), Texts{"[cancelled Room]"});
  EXPECT_FALSE(world.conversation->waits_for_answer());
  world.hold_queries = false;
  world.run();
  EXPECT_EQ(world.said(), Texts{}); // the late answer is nobody's
}

TEST(Enquiry, ATurnThatComesWhileItLooksWaitsForItsTurn) {
  World world(std::string(from_database) + R"xml(
    <topic name="Task"><slot name="Thing" type="Functional"
      question="Which thing?"/></topic>)xml");
  world.database = [](const QueryRequest&) -> Expected<ResultSet> {
    return rows({"name"}, {"Hall"});
  };
  world.hold_queries = true;
  world.say(inform("Room", {{"Size", 9}}));
  world.say(inform("Task", {}));
  EXPECT_EQ(world.said(), Texts{});
  world.hold_queries = false;
  world.run();
  auto said = world.said();
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[0].rfind("[answer Room", 0), 0u);
  EXPECT_EQ(said[1], "Which thing?");
}

} // namespace
} // namespace parlour::dialogue
