// Conversations that go on with another port, which knows nothing of what was
// asked of the one before (engine rule 7.9).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "script/dialogue/engine/conversation.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A handler that does this when the bell rings.
std::string when_it_rings(const std::string& statements) {
  return "<handler name='Bell'><messages><component><Bell><Rings><try>" +
         statements +
         "<catch name='e'><speak param='{e.kind}: {e.message}'/></catch></try>"
         "</Rings></Bell></component></messages></handler>";
}

TEST(ConversationResumed, TimersAndWaitsEndWhenTheyWereDue) {
  World world(when_it_rings("<timer name='knock' after='3s'>"
                            "<speak param='Knock.'/></timer>"
                            "<wait for='2s'/><speak param='A bell.'/>"));
  world.event("Bell", "Rings");
  world.advance(1s);
  world.interrupt();
  world.advance(999ms);
  EXPECT_THAT(world.said(), IsEmpty());
  world.advance(1ms);
  EXPECT_THAT(world.said(), ElementsAre("A bell."));
  world.interrupt();
  world.now += 3'600'000; // nothing ran meanwhile
  world.advance(0ms);
  EXPECT_THAT(world.said(), ElementsAre("Knock."));
}

TEST(ConversationResumed, SilenceIsCountedFromWhereItBegan) {
  World world("<topic name='Taxi'><slot name='Where' type='Functional' "
              "question='Where to?'/></topic>");
  world.say(inform("Taxi", {}));
  EXPECT_THAT(world.said(), ElementsAre("Where to?"));
  world.advance(7s);
  world.interrupt();
  world.advance(1s);
  EXPECT_EQ(world.said().size(), 1u);
}

// Nothing is silently done twice.
TEST(ConversationResumed, WhatIsRequestedIsInDoubt) {
  World world(
      when_it_rings("<request module='Telephone' command='Call' param='5'/>"));
  world.components["Telephone"] = {"Telephone"};
  world.event("Bell", "Rings");
  EXPECT_THAT(world.posted(), ElementsAre("Telephone.Call(5)"));
  world.interrupt();
  world.run();
  EXPECT_THAT(world.said(), ElementsAre(HasSubstr("InDoubt: the session was")));
  EXPECT_THAT(world.posted(), IsEmpty());
  EXPECT_FALSE(world.conversation->waits_for_answer());
}

TEST(ConversationResumed, AnAnswerThatHasComeCounts) {
  World world(
      when_it_rings("<request module='Telephone' command='Call' param='5'/>"
                    "<speak param='They are there.'/>"));
  world.components["Telephone"] = {"Telephone"};
  world.event("Bell", "Rings");
  Message answer;
  answer.source = "Telephone";
  answer.command = "Connected";
  answer.correlation = world.messages.back().correlation;
  world.take(received(answer));
  world.interrupt();
  world.run();
  EXPECT_THAT(world.said(), ElementsAre("They are there."));
}

TEST(ConversationResumed, WhatScriptsAskOfDatabasesIsInDoubt) {
  World world(when_it_rings("<querydb param='insert into log values (1)'/>"));
  world.hold_queries = true;
  world.event("Bell", "Rings");
  ASSERT_EQ(world.queries.size(), 1u);
  world.interrupt();
  world.run();
  EXPECT_THAT(world.said(), ElementsAre(HasSubstr("InDoubt")));
  EXPECT_TRUE(world.queries.empty());
}

TEST(ConversationResumed, SoAreFilesAndComponents) {
  for (const char* statement :
       {"<writefile name='a.txt' param='a'/>", "<load plugin='Lamp'/>"}) {
    World world(when_it_rings(statement));
    world.event("Bell", "Rings");
    world.interrupt();
    world.run();
    EXPECT_THAT(world.said(), ElementsAre(HasSubstr("InDoubt"))) << statement;
    EXPECT_TRUE(world.changes.empty());
  }
}

// A topic's query only reads: it is asked again.
TEST(ConversationResumed, AnEnquiryLooksUpAgain) {
  World world("<topic name='Shops' kind='enquiry'><slot name='Kind'/>"
              "<query source='db' param='select name from shop'>"
              "<by slot='Kind' column='kind'/></query>"
              "<filled><speak param='Found.'/></filled>"
              "</topic>");
  world.database = [](const QueryRequest&) {
    return rows({"name"}, {"Ann's"});
  };
  world.hold_queries = true;
  world.say(inform("Shops", {{"Kind", "food"}}));
  ASSERT_EQ(world.queries.size(), 1u);
  const auto asked = world.queries.front();
  world.interrupt();
  ASSERT_EQ(world.queries.size(), 1u);
  EXPECT_EQ(world.queries.front().id, asked.id);
  EXPECT_EQ(world.queries.front().sql, asked.sql);
  EXPECT_EQ(world.queries.front().values, asked.values);
  world.hold_queries = false;
  world.run();
  EXPECT_THAT(world.said(), ElementsAre("Found."));
}

TEST(ConversationResumed, ATopicsFrameIsAskedForAgain) {
  World world("<topic name='Taxi'><slot name='Where' type='Functional' "
              "question='Where to?'/><slot name='When' type='Functional' "
              "question='When?'/></topic>");
  world.queue(inform("Taxi", {{"Where", "Sentosa"}}));
  while (!world.conversation->awaiting_frame()) {
    ASSERT_TRUE(world.conversation->has_work());
    world.take(input::Stepped());
  }
  world.interrupt();
  EXPECT_TRUE(world.conversation->awaiting_frame());
  world.run();
  EXPECT_EQ(world.slot("Taxi", "Where"), Value("Sentosa"));
  EXPECT_THAT(world.said(), ElementsAre("When?"));
}

TEST(ConversationResumed, WhatWasNotHeardToItsEndIsSaidAgain) {
  World world(when_it_rings("<speak param='A bell.'/>"));
  world.hold_outputs = true;
  world.event("Bell", "Rings");
  EXPECT_THAT(world.said(), ElementsAre("A bell."));
  world.interrupt();
  EXPECT_THAT(world.said(), ElementsAre("A bell."));
  ASSERT_EQ(world.playing.size(), 1u);
  world.hold_outputs = false;
  world.run();
  world.interrupt();
  EXPECT_THAT(world.said(), IsEmpty());
}

TEST(ConversationResumed, WordsAreAskedForAgain) {
  World world("<topic name='Taxi'><slot name='Where' type='Functional' "
              "question='Where to?'/></topic>");
  world.components["Poet"] = {"NLG"};
  world.say(inform("Taxi", {}));
  EXPECT_THAT(world.posted(), ElementsAre("NLG.Generate(Where to?)"));
  world.interrupt();
  EXPECT_THAT(world.posted(), ElementsAre("NLG.Generate(Where to?)"));
  world.event("Poet", "Speak", {"Whither?"}, world.messages.back().correlation);
  EXPECT_THAT(world.said(), ElementsAre("Whither?"));
}

TEST(ConversationResumed, OwnWordsDoWhereNobodyHasOthers) {
  World world("<topic name='Taxi'><slot name='Where' type='Functional' "
              "question='Where to?'/></topic>");
  world.components["Poet"] = {"NLG"};
  world.say(inform("Taxi", {}));
  world.components.erase("Poet");
  world.interrupt();
  world.run();
  EXPECT_THAT(world.said(), ElementsAre("Where to?"));
}

TEST(ConversationResumed, AnOpenSocketHasClosed) {
  World world(when_it_rings("<socket name='lamp' connect='lamp:1'/>"
                            "<speak param='Connected.'/>") +
              "<handler name='Lamp'><messages><component><lamp>"
              "<Closed><speak param='{_LPARAM1}'/></Closed>"
              "</lamp></component></messages></handler>");
  world.event("Bell", "Rings");
  world.answer_socket();
  EXPECT_THAT(world.said(), ElementsAre("Connected."));
  world.interrupt();
  world.run();
  EXPECT_THAT(world.said(), ElementsAre(HasSubstr("connection was lost")));
}

TEST(ConversationResumed, OneThatWasBeingOpenedIsAnError) {
  World world(when_it_rings("<socket name='lamp' connect='lamp:1'/>"));
  world.event("Bell", "Rings");
  world.interrupt();
  world.run();
  EXPECT_THAT(world.said(), ElementsAre(HasSubstr("Network: the connection")));
  EXPECT_TRUE(world.opening.empty());
}

TEST(ConversationResumed, SubscriptionsAreToldAgain) {
  World world(when_it_rings("<subscribe source='Door'/>"));
  world.event("Bell", "Rings");
  const auto wanted = world.subscriptions;
  ASSERT_EQ(wanted.size(), 1u);
  world.interrupt();
  EXPECT_EQ(world.subscriptions, wanted);
}

// Also what was lost and is not told yet is kept.
TEST(ConversationResumed, MayBeInterruptedAgainAtOnce) {
  World world(
      when_it_rings("<request module='Telephone' command='Call' param='5'/>"));
  world.components["Telephone"] = {"Telephone"};
  world.event("Bell", "Rings");
  world.interrupt();
  world.interrupt();
  world.run();
  EXPECT_THAT(world.said(), ElementsAre(HasSubstr("InDoubt")));
}

TEST(ConversationResumed, OneThatHasEndedWantsNothing) {
  World world(when_it_rings("<wait for='2s'/>"));
  world.event("Bell", "Rings");
  world.take(input::Closed());
  world.run();
  world.interrupt();
  EXPECT_EQ(world.timers(), 0u);
  EXPECT_FALSE(world.conversation->has_work());
}

} // namespace
} // namespace parlour::dialogue
