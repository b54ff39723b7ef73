// Whole conversations with small applications; the test enters acts, so no
// understanding is needed.
#include <gtest/gtest.h>

#include "script/dialogue/engine/conversation.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

// The receptionist's two topics in small (dialogues, the acceptance trace).
constexpr const char* reception = R"xml(
  <state name="Welcome"><Entrance><speak param="Good morning."/></Entrance>
  </state>
  <topic name="Appointment">
    <slot name="Visitor" type="Functional" question="Who are you?"/>
    <slot name="Organisation"/>
    <slot name="Host" type="Functional" question="Whom do you meet?"/>
    <slot name="Time" type="Functional" question="What's the time?">
      <cardinality type="time"/>
      <help><value>When is it?</value></help>
      <explain><value>I need the time.</value></explain>
    </slot>
    <filled>
      <speak param="I will call {this.Host}."/>
      <querydb param="insert into rr_meeting values (?)" args="this.Time"/>
      <post module="Telephone" command="Call" param="this.Host"/>
    </filled>
    <completed><post module="Log" command="Done" param=""/></completed>
  </topic>
  <topic name="Facility" kind="enquiry">
    <slot name="Category" type="Functional" question="What do you look for?"/>
    <slot name="Location"/>
    <query source="db" param="select name, level from rr_facility">
      <by slot="Category" column="category"/>
      <by slot="Location" column="level" relax="1"/>
    </query>
    <filled>
      <speak param="{this.rows.count} found, {length(this.relaxed)} relaxed."/>
    </filled>
  </topic>)xml";

WorldOptions starting_at(const char* state) {
  WorldOptions options;
  options.start = state;
  return options;
}

struct Reception : World {
  Reception() : World(reception, starting_at("Welcome")) {
    database = [](const QueryRequest& request) -> Expected<ResultSet> {
      if (request.values.size() == 2) // category and level
        return rows({"name", "level"}, {});
      if (request.values.at(0) == Value("food court"))
        return rows({"name", "level"}, {"Food Chain", -1});
      return rows({"name", "level"}, {"Starbucks", 1, "Ya Kun", 1});
    };
  }
};

const Value introduction =
    inform("Appointment", Map{{"Visitor", "David"},
                              {"Organisation", "Comptec"},
                              {"Host", "Dr. Jeffery Ho"}});

Value enquiry(Map slots, bool elliptical = false) {
  return Map{{"act", "request"},
             {"topic", "Facility"},
             {"slots", slots},
             {"elliptical", elliptical}};
}

TEST(Conversation, AcceptanceTrace) {
  Reception world;
  EXPECT_EQ(world.said(), Texts{"Good morning."});
  world.queue(introduction);
  world.queue(enquiry({{"Category", "coffee shop"}, {"Location", 2}}));
  world.run();
  EXPECT_EQ(world.said(), Texts{"2 found, 1 relaxed."});
  world.say(enquiry({{"Category", "food court"}}, true));
  EXPECT_EQ(world.said(), Texts{"1 found, 0 relaxed."});
  world.advance(1999ms);
  EXPECT_EQ(world.said(), Texts{});
  world.advance(1ms);
  EXPECT_EQ(world.said(), Texts{"What's the time?"});
  EXPECT_EQ(world.slot("Appointment", "Visitor"), "David");
  world.posted();
  world.say(inform({}, {{"Time", "10:30"}}));
  EXPECT_EQ(world.said(), Texts{"I will call Dr. Jeffery Ho."});
  EXPECT_EQ(world.posted(),
            (Texts{"Telephone.Call(Dr. Jeffery Ho)", "Log.Done()"}));
  EXPECT_EQ(world.conversation->current_topic(), "");
}

// Everything that a conversation did: its words, messages and inspections.
Texts record(const WorldOptions& options) {
  World world(std::string(reception) + R"xml(
    <handler name="H"><messages><component><Bell><Rings>
      <speak param="{random(1, 1000)} {random(1, 1000)}"/>
      </Rings></Bell></component></messages></handler>)xml",
              options);
  world.database = [](const QueryRequest& request) -> Expected<ResultSet> {
    return rows({"sql"}, {request.sql});
  };
  world.say(introduction);
  world.say(enquiry({{"Category", "coffee shop"}, {"Location", 2}}));
  world.event("Bell", "Rings");
  world.advance(15s);
  world.say("help");
  world.say(inform({}, {{"Time", "10:30"}}));
  world.say("bye");
  auto all = world.said();
  for (auto& text : world.posted())
    all.push_back(std::move(text));
  for (auto kind : {InspectionKind::slot, InspectionKind::topic,
                    InspectionKind::output, InspectionKind::error})
    for (auto& text : world.seen(kind))
      all.push_back(std::move(text));
  return all;
}

TEST(Conversation, EqualInputsGiveEqualOutputs) {
  auto options = starting_at("Welcome");
  const auto once = record(options);
  EXPECT_GT(once.size(), 20u);
  EXPECT_EQ(once, record(options));
  options.seed = 2;
  EXPECT_NE(once, record(options));
}

TEST(Conversation, NothingHappensWhereNothingCan) {
  Reception world;
  EXPECT_FALSE(world.conversation->has_work());
  const auto steps = world.steps;
  world.take(input::Stepped());
  EXPECT_FALSE(world.conversation->has_work());
  world.run();
  EXPECT_EQ(world.steps, steps);
}

TEST(Conversation, EndsWhenNobodyComesBack) {
  Reception world;
  world.advance(59s);
  EXPECT_FALSE(world.has_ended);
  world.advance(1s);
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.timers(), 0u);
  world.say(introduction); // too late
  EXPECT_EQ(world.said(), Texts{"Good morning."});
}

TEST(Conversation, SilenceIsMeasuredFromTheLastThingThatHappened) {
  Reception world;
  world.advance(50s);
  world.say("thank");
  world.advance(50s);
  EXPECT_FALSE(world.has_ended);
  world.advance(10s);
  EXPECT_TRUE(world.has_ended);
}

TEST(Conversation, AnErrorInInitialValuesEndsItAtOnce) {
  WorldOptions options;
  options.start = "Welcome";
  World world(std::string("<var name='x' expr='1 / (2 - 2)'/>") + reception,
              options);
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
}

TEST(Conversation, WhatCameAfterGoodbyeIsHandedBack) {
  Reception world;
  world.queue(act("bye"));
  world.queue(introduction);
  world.run();
  EXPECT_TRUE(world.has_ended);
  world.repeats = false;
  auto unread = world.conversation->take_unread();
  ASSERT_EQ(unread.size(), 1u);
  EXPECT_EQ(unread[0].params[0], introduction);
  EXPECT_TRUE(world.conversation->take_unread().empty());
}

TEST(Conversation, CloseInTheMiddleOfEverything) {
  Reception world;
  world.hold_queries = true;
  world.say(introduction);
  world.say(enquiry({{"Category", "bank"}}));
  world.take(input::Closed());
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.timers(), 0u);
  world.hold_queries = false;
  world.run();
  world.take(input::Closed()); // once is enough
}

TEST(Conversation, LooksInside) {
  Reception world;
  world.say(introduction);
  EXPECT_EQ(world.conversation->state(), "Welcome");
  EXPECT_EQ(world.conversation->current_topic(), "Appointment");
  EXPECT_EQ(world.slot("Appointment", "Host"), "Dr. Jeffery Ho");
  EXPECT_EQ(world.slot("Appointment", "Nothing"), Value());
  EXPECT_EQ(world.slot("Nothing", "Host"), Value());
}

} // namespace
} // namespace parlour::dialogue
