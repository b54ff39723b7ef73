// Each attribute has its effect: the same conversation runs with one attribute
// changed.
#include <gtest/gtest.h>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

std::string with(std::string script, const std::string& word) {
  const std::string hole = "{X}";
  for (auto at = script.find(hole); at != std::string::npos;
       at = script.find(hole))
    script.replace(at, hole.size(), word);
  return script;
}

using Talk = void (*)(World& world);

Texts hold(const std::string& script, const std::string& word, Talk talk,
           WorldOptions options = {}) {
  World world(with(script, word), options);
  talk(world);
  return world.said();
}

TEST(Attributes, Initiative) {
  const std::string script = R"xml(
    <topic name="Taxi" initiative="{X}">
      <slot name="Place" type="Functional" question="Where?" confirm="never"/>
      <slot name="Time" type="Functional" question="When?" confirm="never"/>
      <completed><speak param="Done."/></completed></topic>)xml";
  Talk talk = [](World& world) {
    world.advance(3s);
    world.say(inform("Taxi", {{"Place", "Hall"}}));
  };
  EXPECT_EQ(hold(script, "user", talk),
            Texts{"[acknowledge Taxi {missing: Time}]"});
  EXPECT_EQ(hold(script, "mixed", talk), Texts{"When?"});
  EXPECT_EQ(hold(script, "system", talk), (Texts{"Where?", "When?"}));
  Talk at_once = [](World& world) {
    world.say(inform("Taxi", {{"Place", "Hall"}, {"Time", "9"}}));
  };
  EXPECT_EQ(hold(script, "user", at_once), Texts{"Done."});
  EXPECT_EQ(hold(script, "mixed", at_once), Texts{"Done."});
  EXPECT_EQ(hold(script, "system", at_once),
            (Texts{"Where?", "[one_by_one Taxi]", "When?"}));
}

constexpr const char* confirming = R"xml(
  <topic name="Taxi">
    <slot name="Place" type="Functional" confirm="{X}"/>
    <slot name="Time" type="Functional"/></topic>)xml";

Texts grounded(const char* policy, double confidence) {
  World world(with(confirming, policy));
  world.say(inform("Taxi", {{"Place", slot_value("Hall", confidence)}}));
  return world.said();
}

TEST(Attributes, Confirm) {
  const Texts asks{"[confirm Taxi.Place {value: Hall}]"};
  const Texts marks{"[question Taxi.Time {implicit: {Place: Hall}}]"};
  const Texts goes_on{"[question Taxi.Time]"};
  EXPECT_EQ(grounded("explicit", 0.99), asks);
  EXPECT_EQ(grounded("implicit", 0.99), marks);
  EXPECT_EQ(grounded("never", 0.5), goes_on);
  EXPECT_EQ(grounded("auto", 0.3), Texts{"[question Taxi.Place]"}); // rejected
  EXPECT_EQ(grounded("auto", 0.5), asks);
  EXPECT_EQ(grounded("auto", 0.8), marks);
  EXPECT_EQ(grounded("auto", 0.95), goes_on);
}

TEST(Attributes, Resume) {
  const std::string script = R"xml(
    <topic name="Taxi" resume="{X}">
      <slot name="Place" type="Functional" question="Where?"/></topic>
    <topic name="Weather"><slot name="Day" type="Functional"/></topic>)xml";
  Talk talk = [](World& world) {
    world.say(inform("Taxi", {}));
    world.say(inform("Weather", {{"Day", "Monday"}}));
    world.advance(3s);
  };
  EXPECT_EQ(hold(script, "always", talk), (Texts{"Where?", "Where?"}));
  EXPECT_EQ(hold(script, "ask", talk), (Texts{"Where?", "[resume Taxi]"}));
  EXPECT_EQ(hold(script, "never", talk), Texts{"Where?"});
}

TEST(Attributes, TypeOfASlot) {
  const std::string script = R"xml(
    <topic name="Taxi"><slot name="Place" type="{X}" question="Where?"/>
      <completed><speak param="Done."/></completed></topic>)xml";
  Talk talk = [](World& world) { world.say(inform("Taxi", {})); };
  EXPECT_EQ(hold(script, "Functional", talk), Texts{"Where?"});
  EXPECT_EQ(hold(script, "Informational", talk), Texts{"Done."});
}

TEST(Attributes, KindOfATopic) {
  const std::string script = R"xml(
    <topic name="Bus" kind="{X}"><slot name="Line" type="Functional"
      question="Which line?"/><slot name="Stop"/>
      <filled><speak param="At noon."/></filled></topic>
    <topic name="Weather"><slot name="Day" type="Functional"/></topic>)xml";
  Talk talk = [](World& world) {
    world.say(inform("Bus", {}));
    world.say(inform("Weather", {{"Day", "Monday"}}));
    world.advance(3s); // an enquiry is never unfinished
  };
  EXPECT_EQ(hold(script, "task", talk), (Texts{"Which line?", "Which line?"}));
  EXPECT_EQ(hold(script, "enquiry", talk), Texts{"Which line?"});
}

TEST(Attributes, Needs) {
  const std::string script = R"xml(
    <topic name="Visitor"><slot name="Name" type="Functional"
      question="Your name?"/></topic>
    <topic name="Taxi" {X}><slot name="Place" type="Functional"
      question="Where?"/></topic>)xml";
  Talk talk = [](World& world) { world.say(inform("Taxi", {})); };
  EXPECT_EQ(hold(script, "", talk), Texts{"Where?"});
  EXPECT_EQ(hold(script, "needs='Visitor'", talk), Texts{"Your name?"});
}

TEST(Attributes, Private) {
  for (const bool is_private : {false, true}) {
    World world(with(R"xml(<topic name="Taxi">
        <slot name="Phone" type="Functional" private="{X}"/></topic>)xml",
                     is_private ? "true" : "false"));
    world.say(inform("Taxi", {{"Phone", "91234567"}}));
    std::string seen;
    for (const auto& text : world.seen(InspectionKind::slot))
      seen += text + "\n";
    EXPECT_EQ(seen.find("91234567") == std::string::npos, is_private) << seen;
  }
}

TEST(Attributes, WordingsOfAQuestion) {
  Talk talk = [](World& world) {
    world.say(inform("Taxi", {}));
    world.say("explain");
    world.say("rephrase");
  };
  const std::string script =
      "<topic name=\"Taxi\"><slot name=\"Place\" type=\"Functional\" "
      "question=\"Where?\">{X}</slot></topic>";
  EXPECT_EQ(hold(script, "", talk),
            (Texts{"Where?", "[explain Taxi.Place]", "Where?", "Where?"}));
  EXPECT_EQ(hold(script,
                 "<help><value>To which place?</value></help>"
                 "<explain><value>The driver asks me.</value></explain>",
                 talk),
            (Texts{"Where?", "The driver asks me.", "To which place?",
                   "To which place?"}));
}

TEST(Attributes, CountOfALadder) {
  Talk talk = [](World& world) {
    world.say(inform("Taxi", {}));
    world.say(act("nonsense"));
    world.say(act("nonsense"));
  };
  const std::string slot =
      "<topic name=\"Taxi\"><slot name=\"Place\" type=\"Functional\" "
      "question=\"Where?\">{X}</slot></topic>";
  EXPECT_EQ(hold(slot, "", talk), (Texts{"Where?", "Where?", "Where?"}));
  EXPECT_EQ(hold(slot, "<nomatch count='1'><speak param='A place?'/></nomatch>",
                 talk),
            (Texts{"Where?", "A place?", "A place?"}));
  EXPECT_EQ(hold(slot, "<nomatch count='2'><speak param='A place?'/></nomatch>",
                 talk),
            (Texts{"Where?", "Where?", "A place?"}));
  const auto with_repair = with(slot, "") +
                           "<repair act=\"no_match\" "
                           "count=\"{X}\"><say act=\"person\"/>"
                           "</repair>";
  EXPECT_EQ(hold(with_repair, "2", talk),
            (Texts{"Where?", "Where?", "[person Taxi.Place]"}));
  EXPECT_EQ(hold(with_repair, "1", talk),
            (Texts{"Where?", "[person Taxi.Place]", "[person Taxi.Place]"}));
}

TEST(Attributes, WaitingTimes) {
  const std::string script = R"xml(
    <topic name="Taxi"><slot name="Place" type="Functional" question="Where?"/>
    </topic>
    <topic name="Weather"><slot name="Day" type="Functional"/></topic>)xml";
  auto said_by = [&](const char* sessions, Milliseconds time) {
    WorldOptions options;
    options.sessions = sessions;
    World world(script, options);
    world.say(inform("Taxi", {}));
    world.say(inform("Weather", {{"Day", "Monday"}}));
    world.said();
    world.advance(time);
    return world.said().size();
  };
  EXPECT_EQ(said_by("resume-after='2s'", 1900ms), 0u);
  EXPECT_EQ(said_by("resume-after='2s'", 2s), 1u);
  EXPECT_EQ(said_by("resume-after='1s'", 1900ms), 1u);
  EXPECT_EQ(said_by("no-input-after='8s'", 9s), 1u);
  EXPECT_EQ(said_by("no-input-after='4s'", 9s), 2u);
}

TEST(Attributes, Capture) {
  const std::string script = R"xml(
    <state name="Guard" capture="{X}">
      <Messages><component><Dialogue><thank><speak param="Hm."/></thank>
      </Dialogue></component></Messages></state>
    <topic name="Taxi"><slot name="Place" type="Functional" question="Where?"/>
    </topic>)xml";
  WorldOptions options;
  options.start = "Guard";
  Talk talk = [](World& world) {
    world.say("thank");
    world.say(inform("Taxi", {}));
  };
  EXPECT_EQ(hold(script, "false", talk, options),
            (Texts{"Hm.", "[thank]", "Where?"}));
  EXPECT_EQ(hold(script, "true", talk, options), (Texts{"Hm.", "[no_match]"}));
}

} // namespace
} // namespace parlour::dialogue
