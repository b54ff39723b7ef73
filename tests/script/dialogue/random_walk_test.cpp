// Conversations with random inputs: after each input they become quiet, memory
// stays bounded, no script fails, and silence ends them.
#include <random>

#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* everything = R"xml(
  <state name="Idle"/>
  <state name="Sub" capture="true"><Messages><component>
    <Bell><Stops><pop/></Stops></Bell>
    <Dialogue><deny><pop/></deny></Dialogue></component></Messages></state>
  <topic name="Task">
    <slot name="A" type="Functional" question="A?">
      <cardinality type="set"><value>red</value><value>dark red</value>
      </cardinality>
      <filled><confirm question="Really {this.A}?"><no><clear slot="A"/></no>
      </confirm></filled></slot>
    <slot name="B" type="Functional" question="B?" confirm="explicit"/>
    <slot name="C"><noinput><ask slot="C"/></noinput></slot>
    <constraint cond="this.C ne 'bad'" message="Bad."/>
    <filled><if cond="this.C == 'push'"><push state="Sub"/></if></filled>
  </topic>
  <topic name="Other" needs="Task" resume="ask">
    <slot name="A" type="Functional" question="Other A?"/>
    <filled><querydb param="select 1" return="r"/></filled></topic>
  <topic name="Auto" initiative="system">
    <slot name="D" type="Functional" question="D?"/></topic>
  <topic name="Ask" kind="enquiry">
    <slot name="C" type="Functional" question="Which C?"/><slot name="D"/>
    <query source="db" param="select name from t"><by slot="C" column="c"/>
      <by slot="D" column="d" relax="1"/></query></topic>
  <handler name="H"><messages><component><Bell>
    <Rings><push state="Sub"/></Rings>
    <Asks><confirm question="Handler?"/></Asks>
    <Waits><wait for="3s"/><activate topic="Task"/></Waits>
    <Times><timer name="t" after="1s" repeat="true"><set name="n"
      expr="n + 1"/><if cond="n gt 5"><cancel timer="t"/></if></timer></Times>
    </Bell></component></messages></handler>
  <var name="n" expr="0"/>)xml";

class Walk {
public:
  explicit Walk(unsigned seed) : random_(seed), world(everything) {
    world.components["Bell"] = {};
    world.database = [this](const QueryRequest&) -> Expected<ResultSet> {
      if (any(4) == 0)
        return fail(ErrorKind::database, "gone");
      return rows({"name"}, any(2) == 0 ? List{} : List{"x"});
    };
  }

  void step() {
    switch (any(9)) {
    case 0:
      world.event("Bell", pick({"Rings", "Stops", "Asks", "Waits", "Times"}));
      break;
    case 1:
    case 2:
      world.advance(Milliseconds(100 * any(60)));
      break;
    case 3:
      world.say(pick({"help", "repeat", "cancel", "restart", "greet", "thank",
                      "confirm", "deny", "explain", "options", "rephrase",
                      "abandon", "person", "wait", "protest", "refuse"}));
      break;
    case 5: // somebody is heard, who may say nothing
      world.event("Keyboard", pick({"Partial", "Rejected"}), {"er"});
      break;
    case 4:
      world.hold_queries = !world.hold_queries;
      world.queue(random_act());
      world.say(random_act());
      break;
    default:
      world.say(any(3) == 0 ? Value(List{random_act(), random_act()})
                            : random_act());
    }
    ASSERT_FALSE(world.conversation->has_work());
  }

  void rest() {
    world.hold_queries = false;
    world.advance(std::chrono::minutes(30));
  }

private:
  unsigned any(unsigned count) {
    return static_cast<unsigned>(random_() % count);
  }
  const char* pick(std::vector<const char*> from) {
    return from[any(static_cast<unsigned>(from.size()))];
  }
  Value random_value() {
    Value value = pick({"red", "dark red", "blue", "bad", "push", "1"});
    if (any(3) == 0)
      return slot_value(value, 0.1 * any(11));
    if (any(6) == 0)
      return Map{{"candidates", List{"red", "dark red"}}, {"text", "red"}};
    return value;
  }
  Value random_act() {
    Map slots;
    for (const char* name : {"A", "B", "C", "D"})
      if (any(3) == 0)
        slots.set(name, random_value());
    Value topic =
        any(2) == 0 ? Value() : Value(pick({"Task", "Other", "Auto", "Ask"}));
    Map made{{"act", pick({"inform", "inform", "request", "correct", "deny"})},
             {"topic", topic},
             {"slots", slots},
             {"elliptical", any(4) == 0}};
    return made;
  }

  std::mt19937 random_; // before the world, whose functions use it

public:
  World world;
};

TEST(RandomWalk, ComesToRestAndToAnEnd) {
  for (unsigned seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    Walk walk(seed);
    for (int i = 0; i < 120 && !walk.world.has_ended; ++i)
      ASSERT_NO_FATAL_FAILURE(walk.step());
    walk.rest();
    EXPECT_TRUE(walk.world.has_ended);
    EXPECT_EQ(walk.world.timers(), 0u);
    for (const auto& error : walk.world.seen(InspectionKind::error))
      EXPECT_TRUE(error.find("gone") != std::string::npos ||
                  error.find("for this frame") != std::string::npos)
          << error;
  }
}

} // namespace
} // namespace parlour::dialogue
