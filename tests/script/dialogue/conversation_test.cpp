// Whole conversations on small applications, without understanding.
#include <gtest/gtest.h>

#include "script/dialogue/conversation.hpp"
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

} // namespace
} // namespace parlour::dialogue
