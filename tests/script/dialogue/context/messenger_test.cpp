// Events that are raised in a conversation, messages that are posted, and their
// limits.
#include <gtest/gtest.h>

#include "runtime/base/defaults.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct MessengerTest : testing::Test {
  MessengerTest()
      : world("<topic name='T'><slot name='S'/></topic>"),
        interpreter(world.program),
        context(interpreter, world.program,
                {.session = "s2", .seed = 1, .phrases = {}}, world),
        inbox(context.turns), messenger(context, inbox) {}
  World world;
  script::Interpreter interpreter;
  DialogueContext context;
  Inbox inbox;
  Messenger messenger;
};

TEST_F(MessengerTest, APostCarriesTheSessionAndANumberOfItsOwn) {
  auto first = messenger.post("Log", "Line", {"a"}, 0);
  auto second = messenger.post("Log", "Line", {"b"}, 0);
  EXPECT_NE(first, second);
  EXPECT_EQ(world.messages.back().session, "s2");
  EXPECT_EQ(world.messages.back().correlation, second);
  EXPECT_EQ(world.messages.back().sinks, std::vector<std::string>{"Log"});
}

TEST_F(MessengerTest, WhatIsPostedIsARoundFurtherAway) {
  Message handled;
  handled.rounds = 3;
  inbox.handles(handled);
  messenger.post("Log", "Line", {}, 0);
  EXPECT_EQ(world.messages.back().rounds, 4u);
  messenger.post_for_another({});
  EXPECT_EQ(world.messages.back().rounds, 4u);
}

TEST_F(MessengerTest, WhatAnInlineComponentAnswersIsAnInternalEvent) {
  world.answers = [](const Message& message) {
    Message answer;
    answer.source = "Echo";
    answer.correlation = message.correlation;
    return std::vector<Message>{answer};
  };
  const auto correlation = messenger.post("Echo", "Say", {}, 0);
  EXPECT_TRUE(messenger.is_answered(correlation));
  EXPECT_EQ(inbox.take_internal().message->source, "Echo");
}

TEST_F(MessengerTest, RaisedEventsHoldTheirTurnUntilTheyAreDropped) {
  const auto turn = context.turns.begin();
  messenger.raise("Script", "Again", {}, turn);
  EXPECT_TRUE(context.turns.any_open(0));
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(messenger.one_more_internal_event());
  EXPECT_FALSE(messenger.one_more_internal_event());
  EXPECT_FALSE(context.turns.any_open(0));
}

TEST_F(MessengerTest, EventsThatChaseEachOtherAreOneError) {
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(messenger.one_more_internal_event());
  EXPECT_FALSE(messenger.one_more_internal_event());
  ASSERT_TRUE(inbox.has_internal());
  const auto told = inbox.take_internal();
  EXPECT_EQ(told.message->source, "Script");
  EXPECT_EQ(told.message->command, "Error");
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(messenger.one_more_internal_event());
  EXPECT_FALSE(messenger.one_more_internal_event());
  EXPECT_FALSE(inbox.has_internal());
}

} // namespace
} // namespace parlour::dialogue
