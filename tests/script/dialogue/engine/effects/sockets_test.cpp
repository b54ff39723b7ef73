// TCP clients of scripts, as the conversation sees them.
#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/sockets.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

struct Feed : World {
  explicit Feed(const std::string& statements, const std::string& more = "")
      : World(R"xml(<handler name="H"><messages><component>
          <Bell><Rings><try>)xml" +
              statements + R"xml(
            <catch name="e"><speak param="{e.kind}: {e.message}"/></catch>
            </try></Rings></Bell>
          <feed><Data><speak param="{_SOURCE}: {_LPARAM1}"/></Data>
            <Closed><speak param="closed: {_LPARAM1}"/></Closed></feed>
          </component></messages></handler>)xml" +
              more) {
    components["Bell"] = {};
  }
  void ring() {
    event("Bell", "Rings");
  }
};

constexpr const char* open_feed =
    "<socket name='feed' connect='there:{1 + 1}'/><speak param='open'/>";

TEST(ScriptSockets, AScriptWaitsForTheOpening) {
  Feed world(open_feed);
  world.ring();
  ASSERT_EQ(world.opening.size(), 1u);
  EXPECT_EQ(world.opening[0].name, "feed");
  EXPECT_EQ(world.opening[0].order.address, "there:2");
  EXPECT_TRUE(world.opening[0].order.lines);
  EXPECT_TRUE(world.conversation->waits_for_answer());
  world.answer_socket();
  EXPECT_FALSE(world.conversation->waits_for_answer());
  EXPECT_EQ(world.said(), Texts{"open"});
}

TEST(ScriptSockets, WhatCannotBeOpenedIsAnError) {
  Feed world(open_feed);
  world.ring();
  world.answer_socket("refused");
  EXPECT_EQ(world.said(), Texts{"Network: refused"});
  world.ring(); // the name is free
  EXPECT_EQ(world.opening.size(), 1u);
}

TEST(ScriptSockets, TextsAreEventsOfItsName) {
  Feed world("<socket name='feed' connect='h:1' lines='false'/>");
  world.ring();
  EXPECT_FALSE(world.opening[0].order.lines);
  world.answer_socket();
  world.event("feed", "Data", {"one"});
  world.event("feed", "Data", {"two"});
  EXPECT_EQ(world.said(), (Texts{"feed: one", "feed: two"}));
  EXPECT_EQ(world.sent, (Texts{"feed taken", "feed taken"}));
}

// A handler that waits takes no more; the other side will have to wait.
TEST(ScriptSockets, ATextIsTakenWhenItsHandlerIsDone) {
  Feed world("<socket name='feed' connect='h:1'/>",
             R"xml(<handler name="Slow"><messages><component>
             <feed><Data><wait for="1s"/></Data></feed></component></messages>
             </handler>)xml");
  world.ring();
  world.answer_socket();
  world.event("feed", "Data", {"one"});
  world.event("feed", "Data", {"two"});
  EXPECT_EQ(world.sent, Texts{});
  world.advance(1s);
  EXPECT_EQ(world.sent, Texts{"feed taken"});
  world.advance(1s);
  EXPECT_EQ(world.sent, (Texts{"feed taken", "feed taken"}));
}

TEST(ScriptSockets, SendAndClose) {
  Feed world("<socket name='feed' connect='h:1'/>"
             "<sendsocket name='feed' param='a {1 + 1}'/>"
             "<closesocket name='feed'/><closesocket name='feed'/>"
             "<sendsocket name='feed' param='b'/>");
  world.ring();
  world.answer_socket();
  EXPECT_EQ(world.sent, (Texts{"feed a 2", "feed closed"}));
  EXPECT_EQ(world.said(), Texts{"Network: there is no open socket 'feed'"});
}

TEST(ScriptSockets, TheOtherSideCloses) {
  Feed world("<socket name='feed' connect='h:1'/>");
  world.ring();
  world.answer_socket();
  world.end_socket("feed", "gone");
  EXPECT_EQ(world.said(), Texts{"closed: gone"});
  world.ring();
  EXPECT_EQ(world.opening.size(), 1u); // may be opened again
}

TEST(ScriptSockets, OneOfANameAtATime) {
  Feed world(std::string(open_feed) + open_feed);
  world.ring();
  world.answer_socket();
  EXPECT_EQ(
      world.said(),
      (Texts{"open", "Network: there is a socket 'feed' already; close it "
                     "before"}));
}

// Or its messages would pass for a recogniser's, or the engine's.
TEST(ScriptSockets, NoNameOfSomebodyElse) {
  for (const std::string name :
       {"ASR", "Record", "System", "Bell", "*", "a, b", ""}) {
    Feed world("<socket name=\"{'" + name + "'}\" connect='h:1'/>");
    world.ring();
    EXPECT_EQ(world.opening.size(), 0u) << name;
    EXPECT_EQ(world.said().at(0).rfind("Refused: a socket cannot be called", 0),
              0u);
  }
}

TEST(ScriptSockets, SoManyAndNoMore) {
  Feed world("<for name='i' from='1' to='17'>"
             "<socket name='s{i}' connect='h:1'/></for>");
  world.ring();
  for (int i = 0; i < 16; ++i)
    world.answer_socket();
  EXPECT_EQ(world.said(), Texts{"Network: a session has no more than 16 "
                                "sockets"});
}

TEST(ScriptSockets, AnOpeningThatNobodyWaitsForIsClosed) {
  Feed world("", R"xml(<topic name="T"><slot name="S" type="Functional"
    question="S?"><filled><socket name="feed" connect="h:1"/></filled></slot>
    </topic>)xml");
  world.say(inform("T", {{"S", 1}}));
  ASSERT_EQ(world.opening.size(), 1u);
  world.say("cancel");
  EXPECT_EQ(world.sent, Texts{"? closed"});
}

} // namespace
} // namespace parlour::dialogue
