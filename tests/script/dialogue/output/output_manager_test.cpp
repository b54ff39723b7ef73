// How outputs get their words and are released (engine rule 3).
#include <gtest/gtest.h>

#include "script/dialogue/output/output_manager.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* asks_first = R"xml(
  <topic name="T"><slot name="S" type="Functional" question="S?"/>
    <completed><speak param="Done."/></completed></topic>)xml";

constexpr const char* speaking = R"xml(
  <handler name="N"><messages><component><NLG><Speak>
    <speak param="({_LPARAM1})"/></Speak></NLG></component></messages>
  </handler>)xml";

// With an NLG component that words things when the test says so, or inline.
struct Worded : World {
  explicit Worded(const std::string& script, bool in_line = false)
      : World(script) {
    components["Phrases"] = {"NLG"};
    if (in_line)
      answers = [](const Message& asked) {
        return std::vector<Message>{speak(asked)};
      };
  }
  static Message speak(const Message& asked) {
    Message reply;
    reply.source = "Phrases";
    reply.command = "Speak";
    reply.params = {asked.params[0].if_string()
                        ? asked.params[0]
                        : Value("<" + asked.params[0]["act"].text() + ">")};
    reply.session = asked.session;
    reply.correlation = asked.correlation;
    return reply;
  }
  void word() {
    auto reply = speak(messages.back());
    take(received(std::move(reply)));
    run();
  }
};

TEST(OutputManager, WordsOfAComponentByDefault) {
  Worded world(asks_first);
  world.say(inform("T", {}));
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_EQ(world.posted(), Texts{"NLG.Generate(S?)"});
  world.word();
  EXPECT_EQ(world.said(), Texts{"S?"});
}

TEST(OutputManager, WhoListensToEverythingDoesNotSwallowWords) {
  Worded world(std::string(asks_first) + R"xml(
    <handler name="N"><messages><component>
      <on source="*" event="*"><log param="{_COMMAND}"/></on>
    </component></messages></handler>)xml");
  world.say(inform("T", {}));
  world.word();
  EXPECT_EQ(world.said(), Texts{"S?"});
}

TEST(OutputManager, WordsByAHandler) {
  Worded world(std::string(asks_first) + speaking);
  world.say(inform("T", {}));
  world.word();
  EXPECT_EQ(world.said(), Texts{"(S?)"});
  world.say(inform({}, {{"S", 1}})); // literal speech passes no component
  EXPECT_EQ(world.said(), Texts{"Done."});
}

constexpr const char* listening = R"xml(
  <handler name="E"><messages><component><Script><Error>
    <speak param="{_LPARAM1} in {_LPARAM2}:{_LPARAM3}"/>
    <say act="thank"/>
  </Error></Script></component></messages></handler>)xml";

// The handler's own words fail as well: it is told once in a robot turn.
TEST(OutputManager, APhraseThatFailsIsAnErrorAndAnotherIsSaid) {
  World world(std::string(asks_first) + listening);
  world.fails_to_word = "thank";
  const Texts told{"[thank]", "no number in phrases.xml:7"};
  world.say("thank");
  EXPECT_EQ(world.said(), told);
  EXPECT_EQ(world.seen(InspectionKind::error),
            (Texts{2, "phrase: phrases.xml:7: no number"}));
  world.say("thank");
  EXPECT_EQ(world.said(), told);
}

TEST(OutputManager, TheUserDoesNotHearOfAPhraseThatFails) {
  World world(asks_first);
  world.fails_to_word = "thank";
  world.say("thank");
  EXPECT_EQ(world.said(), Texts{"[thank]"});
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
}

TEST(OutputManager, AComponentTellsOfAPhraseThatFails) {
  Worded world(std::string(asks_first) + listening);
  world.say(inform("T", {}));
  const auto number = world.messages.back().correlation;
  world.event("Phrases", "PhraseFailed", {"no number", "a.xml", 3}, number);
  EXPECT_EQ(world.said(), Texts{}); // the question's words are still to come
  world.event("Phrases", "Speak", {"S?"}, number);
  EXPECT_EQ(world.said(), (Texts{"S?", "no number in a.xml:3"}));
  for (const auto& line : world.seen(InspectionKind::unhandled))
    EXPECT_EQ(line.find("PhraseFailed"), std::string::npos);
}

TEST(OutputManager, InlineWordsNeedNoTimer) {
  Worded world(std::string(asks_first) + speaking, true);
  world.say("thank");
  EXPECT_EQ(world.said(), Texts{"(<thank>)"});
  EXPECT_EQ(world.timers(), 1u); // the session's last only
}

TEST(OutputManager, AComponentThatBreaksIsGivenUpAtOnce) {
  Worded world(asks_first);
  world.answers = [](const Message& asked) {
    auto reply = Worded::speak(asked);
    reply.command = "Failed";
    return std::vector<Message>{reply};
  };
  world.say("thank");
  EXPECT_EQ(world.said(), Texts{"[thank]"});
  world.say(inform("T", {}));
  EXPECT_EQ(world.said(), Texts{"S?"});
}

TEST(OutputManager, WordsDroppedWithChasingEventsAreSpokenAllTheSame) {
  Worded world(std::string(asks_first) + R"xml(
    <handler name="C"><messages><component><Script><Chase>
      <fire event="Chase"/></Chase></Script><Bell><Rings>
      <fire event="Chase"/></Rings></Bell></component></messages></handler>
    <handler name="E"><messages><component><Timer><Fired>
      </Fired></Timer></component></messages></handler>)xml",
               true);
  world.queue(inform("T", {}));
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), (Texts{"S?", "<unavailable>"}));
  world.say("thank");
  EXPECT_EQ(world.said(), (Texts{"<thank>"}));
}

TEST(OutputManager, AComponentThatIsSilentIsGivenUp) {
  Worded world(asks_first);
  world.say("thank");
  EXPECT_TRUE(world.conversation->waits_for_answer());
  world.advance(10s);
  EXPECT_EQ(world.said(), Texts{"[thank]"});
  EXPECT_FALSE(world.conversation->waits_for_answer());
}

TEST(OutputManager, WhatIsReleasedIsSpokenWhereThereIsAVoice) {
  World world(asks_first);
  world.components["Voice"] = {"TTS"};
  world.say(inform("T", {}));
  EXPECT_EQ(world.said(), Texts{"S?"});
  EXPECT_EQ(world.posted(), Texts{"TTS.Speak(S?, 1, true)"});
}

TEST(OutputManager, OrderIsKeptWhileWordsAreWaitedFor) {
  Worded world(std::string(asks_first) + R"xml(
    <handler name="B"><messages><component><Bell><Rings>
      <speak param="Ring."/></Rings></Bell></component></messages></handler>
    )xml");
  world.say("thank");
  world.event("Bell", "Rings");
  EXPECT_EQ(world.said(), Texts{});
  world.word();
  EXPECT_EQ(world.said(), (Texts{"<thank>", "Ring."}));
}

TEST(OutputManager, AWithdrawnQuestionLetsOthersPass) {
  Worded world(std::string(asks_first) + R"xml(
    <topic name="U"><slot name="R" type="Functional"/>
      <completed><speak param="U done."/></completed></topic>)xml");
  world.say(inform("T", {}));                // its words are never given
  world.say(inform("U", {{"R", 1}}));        // suspends it
  EXPECT_EQ(world.said(), Texts{"U done."}); // and is not blocked by it
}

TEST(OutputManager, AQuestionWithoutWordsEndsSomewhere) {
  Worded world(std::string(asks_first) + R"xml(
    <handler name="N"><messages><component><NLG><Speak/></NLG></component>
    </messages></handler>)xml",
               true);
  world.say(inform("T", {}));
  world.advance(10min);
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_TRUE(world.has_ended);
}

TEST(OutputManager, SilenceCountsFromTheEndOfTheSpeech) {
  World world(asks_first);
  world.hold_outputs = true;
  world.say(inform("T", {}));
  EXPECT_EQ(world.said(), Texts{"S?"});
  world.advance(1min);
  EXPECT_EQ(world.said(), Texts{});
  world.hold_outputs = false;
  world.run();
  world.advance(8s);
  EXPECT_EQ(world.said(), Texts{"S?"});
}

TEST(OutputManager, GoodbyeIsSaidBeforeTheEnd) {
  Worded world(asks_first);
  world.say("bye");
  EXPECT_FALSE(world.has_ended);
  world.word();
  EXPECT_EQ(world.said(), Texts{"<bye>"});
  EXPECT_TRUE(world.has_ended);
}

TEST(OutputManager, UncertainValuesAreEchoedOnce) {
  World world(R"xml(<topic name="T"><slot name="A" type="Functional"/>
    <slot name="B" type="Functional"/><slot name="C" type="Functional"/>
    </topic>)xml");
  world.say(inform("T", {{"A", 1}}));
  EXPECT_EQ(world.said(), Texts{"[question T.B {implicit: {A: 1}}]"});
  world.say(inform({}, {{"B", slot_value(2, 0.95)}}));
  EXPECT_EQ(world.said(), Texts{"[question T.C]"});
}

} // namespace
} // namespace parlour::dialogue
