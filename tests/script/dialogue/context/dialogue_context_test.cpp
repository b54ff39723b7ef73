// What is raised, posted and counted in a conversation.
#include <gtest/gtest.h>

#include "script/dialogue/context/dialogue_context.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct Context : testing::Test {
  Context()
      : world("<topic name='T'><slot name='S'/></topic>"),
        context(world.program, {.session = "s2", .seed = 1, .phrases = {}},
                world) {}
  World world;
  DialogueContext context;
};

TEST_F(Context, APostCarriesTheSessionAndANumberOfItsOwn) {
  auto first = context.post("Log", "Line", {"a"}, 0);
  auto second = context.post("Log", "Line", {"b"}, 0);
  EXPECT_NE(first, second);
  EXPECT_EQ(world.messages.back().session, "s2");
  EXPECT_EQ(world.messages.back().correlation, second);
  EXPECT_EQ(world.messages.back().sinks, std::vector<std::string>{"Log"});
}

TEST_F(Context, RaisedEventsHoldTheirTurnUntilTheyAreDropped) {
  const auto turn = context.turns.begin();
  context.raise("Script", "Again", {}, turn);
  EXPECT_TRUE(context.turns.any_open(0));
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(context.one_more_internal_event());
  EXPECT_FALSE(context.one_more_internal_event());
  EXPECT_FALSE(context.turns.any_open(0));
}

// Who handles the error may raise events, too, but is not told again.
TEST_F(Context, EventsThatChaseEachOtherAreOneError) {
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(context.one_more_internal_event());
  EXPECT_FALSE(context.one_more_internal_event());
  ASSERT_EQ(context.internal.size(), 1u);
  EXPECT_EQ(context.internal.front().message->source, "Script");
  EXPECT_EQ(context.internal.front().message->command, "Error");
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(context.one_more_internal_event());
  EXPECT_FALSE(context.one_more_internal_event());
  EXPECT_TRUE(context.internal.empty());
  EXPECT_FALSE(context.one_more_internal_event());
}

// Who words an output waits for its event, also for one that is dropped.
TEST_F(Context, WhatIsTooMuchIsKeptForThoseWhoWaitForIt) {
  context.raise("Script", "Again", {});
  for (int i = 0; i <= defaults::internal_events; ++i)
    context.one_more_internal_event();
  ASSERT_EQ(context.dropped.size(), 1u);
  EXPECT_EQ(context.dropped.front().message->command, "Again");
}

} // namespace
} // namespace parlour::dialogue
