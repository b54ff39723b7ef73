// What the user says while a handler waits for an answer: the conversation goes
// on (language rule 12.16).
#include <gtest/gtest.h>

#include "script/dialogue/engine/answers.hpp"
#include "tests/script/dialogue/speaker.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

constexpr const char* own_topics = R"xml(
  <topic name="Order">
    <slot name="What" type="Functional" question="What?"/>
    <completed><speak param="{this.What} it is."/></completed>
  </topic>
  <topic name="Delete"><completed><speak param="Deleted."/></completed></topic>
  <handler name="Bells"><messages><component><Bell>
    <Rings><speak param="Ring."/></Rings>
  </Bell></component></messages></handler>)xml";

constexpr const char* understand =
    R"(<post module="NLU" command="DoNLU" param="_LPARAM1"/>)";

// An application with these handlers of events.
struct Listener : Speaker {
  explicit Listener(const std::string& events, const std::string& others = "",
                    WorldOptions options = {})
      : Speaker("<handler name='H'><messages><component>" + events +
                    "</component></messages></handler>" + own_topics + others,
                std::move(options)) {}
};

std::string heard(const std::string& statements) {
  return "<ASR><RecognitionResult>" + statements +
         "</RecognitionResult></ASR>"
         "<NLU><FrameInfo><fire param='_LPARAM1'/></FrameInfo></NLU>";
}

std::string meant(const std::string& statements) {
  return "<ASR><RecognitionResult>" + std::string(understand) +
         "</RecognitionResult></ASR><NLU><FrameInfo>" + statements +
         "</FrameInfo></NLU>";
}

// A handler that asks before it lets the words go on.
const std::string asks_about_words =
    heard("<confirm question='Did you say {_LPARAM1}?'><yes>" +
          std::string(understand) +
          "</yes><no><speak param='Again, please.'/></no></confirm>");

TEST(Answers, AreHeardWhereWordsAreConfirmed) {
  Listener world(asks_about_words);
  world.hear("tea");
  EXPECT_EQ(world.said(), Texts{"Did you say tea?"});
  world.hear("yes");
  EXPECT_EQ(world.said(), Texts{"tea it is."});
  world.hear("cocoa");
  EXPECT_EQ(world.said(), Texts{"Did you say cocoa?"});
  world.hear("no");
  EXPECT_EQ(world.said(), Texts{"Again, please."});
}

TEST(Answers, OtherWordsAreAskedAboutInsteadOfTheFirst) {
  Listener world(asks_about_words);
  world.hear("tea");
  world.hear("cocoa");
  world.hear("hm");
  EXPECT_EQ(world.said(), (Texts{"Did you say tea?", "Did you say cocoa?",
                                 "Did you say hm?"}));
  world.hear("no");
  EXPECT_EQ(world.said(), Texts{"Again, please."});
  world.hear("yes"); // nothing is left that it could be an answer to
  EXPECT_EQ(world.said(), Texts{"Did you say yes?"});
}

TEST(Answers, AreHeardWhereTheUnderstandingTakesItsTime) {
  Listener world(asks_about_words);
  world.late = true;
  world.hear("tea");
  world.hear("yes");
  EXPECT_EQ(world.said(), Texts{"Did you say tea?"});
  world.answer_late();
  world.answer_late();
  EXPECT_EQ(world.said(), Texts{"tea it is."});
  world.hear("cocoa");
  world.hear("tea");
  EXPECT_EQ(world.said(), Texts{"Did you say cocoa?"});
  world.answer_late();
  EXPECT_EQ(world.said(), Texts{"Did you say tea?"});
}

TEST(Answers, OnesThatNobodyUnderstandsAreSuchWords) {
  Listener world(asks_about_words);
  world.late = true;
  world.hear("tea");
  EXPECT_EQ(world.said(), Texts{"Did you say tea?"});
  world.hear("yes"); // for an understanding that is down
  world.advance(10s);
  EXPECT_EQ(world.said(), Texts{"Did you say tea?"}); // once more
  world.late = false;
  world.hear("no");
  EXPECT_EQ(world.said(), Texts{"Again, please."});
}

// What he asked about may answer what was asked before.
TEST(Answers, TheQuestionBeforeIsNotForgotten) {
  Listener world(heard("<confirm question='Did you say {_LPARAM1}?'><no>"
                       "<consume/><return/></no></confirm>" +
                       std::string(understand)));
  const auto asked_for = [&] {
    return world.messages.back().params.at(1)["asked"]["slot"].text();
  };
  world.hear("order");
  world.hear("yes");
  EXPECT_EQ(world.said(), (Texts{"Did you say order?", "What?"}));
  world.hear("no");
  world.hear("tea");
  EXPECT_EQ(world.said(), (Texts{"Did you say no?", "Did you say tea?"}));
  world.hear("yes");
  EXPECT_EQ(asked_for(), "What");
  EXPECT_EQ(world.said(), Texts{"tea it is."});
}

const std::string asks_about_acts =
    meant("<confirm question='Sure?'><yes><fire param='_LPARAM1'/></yes>"
          "</confirm>");

TEST(Answers, AreHeardWhereActsAreConfirmed) {
  Listener world(asks_about_acts);
  world.hear("tea");
  EXPECT_EQ(world.said(), Texts{"Sure?"});
  world.hear("yes");
  EXPECT_EQ(world.said(), Texts{"tea it is."});
  world.hear("tea");
  world.hear("cancel");
  EXPECT_EQ(world.said(),
            (Texts{"Sure?", "[cancelled]"})); // nothing had been begun
  world.advance(1h);
  EXPECT_EQ(world.said(), Texts{});
}

// What is guarded stays so, however often it is said.
TEST(Answers, NothingElseGetsPastAHandlerThatWaits) {
  Listener world(asks_about_acts);
  world.hear("delete");
  world.hear("delete");
  world.hear("delete");
  EXPECT_EQ(world.said(), (Texts{"Sure?", "Sure?", "Sure?"}));
  world.hear("no");
  EXPECT_EQ(world.said(), Texts{});
  world.advance(1h);
  EXPECT_EQ(world.said(), Texts{});
}

TEST(Answers, TheQuestionComesAgainAfterSilence) {
  Listener world(asks_about_acts);
  world.hear("tea");
  world.advance(8s);
  EXPECT_EQ(world.said(), (Texts{"Sure?", "Sure?"}));
  world.hear("hm");
  EXPECT_EQ(world.said(), Texts{"Sure?"});
  world.hear("yes");
  EXPECT_EQ(world.said(), Texts{"tea it is."});
}

TEST(Answers, AQuestionIsNotWithdrawnForItsOwnTurn) {
  Listener world("<ASR><RecognitionResult>" + std::string(understand) +
                 "<confirm question='Sure?'><yes><speak param='Good.'/></yes>"
                 "</confirm></RecognitionResult></ASR>");
  world.hear("hm");
  EXPECT_EQ(world.said().front(), "Sure?");
  world.hear("yes");
  EXPECT_EQ(world.said(), Texts{"Good."});
}

// A handler in front of the others: they get the words afterwards.
TEST(Answers, OtherHandlersGoOnAfterAYesAndNotAfterAnEnd) {
  Listener world(
      "<ASR><RecognitionResult><confirm question='Is it {_LPARAM1}?'><no>"
      "<consume/></no></confirm></RecognitionResult></ASR>",
      "<handler name='Next'><messages><component>" + meant(R"(
        <fire param="_LPARAM1"/>)") +
          "</component></messages></handler>");
  world.hear("tea");
  world.hear("yes");
  EXPECT_EQ(world.said(), (Texts{"Is it tea?", "tea it is."}));
  world.hear("tea");
  world.hear("no");
  EXPECT_EQ(world.said(), Texts{"Is it tea?"});
  world.hear("tea");
  world.hear("cocoa");
  world.hear("yes");
  EXPECT_EQ(world.said(),
            (Texts{"Is it tea?", "Is it cocoa?", "cocoa it is."}));
}

constexpr const char* sure = R"xml(
  <state name="Sure">
    <Entrance><speak param="Sure?"/></Entrance>
    <Exit><speak param="Out."/></Exit>
    <Messages><component><Dialogue>
      <confirm><pop/><consume/></confirm>
      <deny><speak param="No."/><consume/></deny>
    </Dialogue></component></Messages>
  </state>)xml";

TEST(Answers, GoToAStateThatAHandlerOfWordsPushed) {
  Listener world(heard("<push state='Sure'/>" + std::string(understand)), sure);
  world.hear("tea");
  EXPECT_EQ(world.said(), Texts{"Sure?"});
  world.hear("no");
  EXPECT_EQ(world.said(), Texts{"No."});
  world.hear("yes");
  EXPECT_EQ(world.said(), (Texts{"Out.", "tea it is."}));
}

TEST(Answers, GoToAStateThatAHandlerOfActsPushed) {
  Listener world(meant("<push state='Sure'/><fire param='_LPARAM1'/>"), sure);
  world.hear("tea");
  EXPECT_EQ(world.said(), Texts{"Sure?"});
  world.hear("yes");
  EXPECT_EQ(world.said(), (Texts{"Out.", "tea it is."}));
  EXPECT_EQ(world.conversation->state(), "");
}

// What the state does not listen to is given to the handler again: it pushes
// anew, and the state before is left.
TEST(Answers, StatesDoNotPileUp) {
  Listener world(meant("<push state='Sure'/><fire param='_LPARAM1'/>"), sure);
  world.hear("tea");
  for (int i = 0; i < 3; ++i)
    world.hear("cocoa");
  EXPECT_EQ(world.said(), (Texts{"Sure?", "Out.", "Sure?", "Out.", "Sure?",
                                 "Out.", "Sure?"}));
  world.hear("yes");
  EXPECT_EQ(world.said(), (Texts{"Out.", "cocoa it is."}));
  EXPECT_EQ(world.conversation->state(), "");
}

TEST(Answers, WhoeverListensToEverythingMayAskToo) {
  Listener world("<on source='*' event='RecognitionResult'><confirm question="
                 "'Sure?'><yes>" +
                 std::string(understand) +
                 "</yes></confirm></on>"
                 "<NLU><FrameInfo><fire param='_LPARAM1'/></FrameInfo></NLU>");
  world.hear("tea");
  world.hear("yes");
  EXPECT_EQ(world.said(), (Texts{"Sure?", "tea it is."}));
}

// -- waiting for time ---------------------------------------------------------

TEST(Answers, WordsDoNotWaitBehindAWait) {
  Listener world(heard("<wait for='1h'/>" + std::string(understand)));
  world.hear("tea");
  world.advance(1s);
  world.hear("cocoa");
  EXPECT_EQ(world.said(), Texts{});
  world.advance(1h);
  EXPECT_EQ(world.said(), (Texts{"tea it is.", "cocoa it is."}));
}

TEST(Answers, AWaitWithdrawsNoQuestion) {
  Listener world(heard("<activate topic='Order'/><wait for='1h'/>"
                       "<speak param='An hour later.'/>"));
  world.hear("hm");
  EXPECT_EQ(world.said(), Texts{"What?"});
  world.advance(8s);
  EXPECT_EQ(world.said(), Texts{"What?"});
}

// A handler that waits for a component holds what comes later, in its order.
TEST(Answers, WordsWaitForAQuery) {
  Listener world(heard("<querydb param='select 1' return='r'/>" +
                       std::string(understand)));
  world.hold_queries = true;
  world.hear("tea");
  world.hear("cocoa");
  EXPECT_EQ(world.said(), Texts{});
  EXPECT_EQ(world.queries.size(), 1u);
  world.hold_queries = false;
  world.run();
  EXPECT_EQ(world.said(), (Texts{"tea it is.", "cocoa it is."}));
}

// What was held behind a query is let go when the handler asks the user; it
// was no answer to that.
TEST(Answers, AYesBeforeTheQuestionIsNone) {
  Listener world(meant("<querydb param='select 1' return='r'/>"
                       "<confirm question='Sure?'><yes>"
                       "<fire param='_LPARAM1'/></yes></confirm>"));
  world.hold_queries = true;
  world.hear("tea");
  world.hear("yes");
  world.hold_queries = false;
  world.run();
  EXPECT_EQ(world.said(), Texts{"Sure?"});
  world.hear("yes");
  EXPECT_EQ(world.said(), Texts{"tea it is."});
}

TEST(Answers, ASessionMayEndWhileAHandlerWaits) {
  WorldOptions options;
  options.sessions = "closes-after='30s'";
  Listener world(asks_about_words, "", options);
  world.hear("tea");
  world.advance(5min);
  EXPECT_TRUE(world.has_ended);
}

} // namespace
} // namespace parlour::dialogue
