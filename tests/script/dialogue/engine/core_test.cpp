// The parts of a conversation together: what cancels waits, what is counted.
#include <gtest/gtest.h>

#include "script/dialogue/engine/core.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct Parts : testing::Test {
  Parts()
      : world("<topic name='T'><slot name='S'/></topic>"),
        core(world.program, {.session = "s2", .seed = 1, .phrases = {}},
             world) {}
  World world;
  Core core;
};

TEST_F(Parts, APostCarriesTheSessionAndANumberOfItsOwn) {
  auto first = core.post("Log", "Line", {"a"}, 0);
  auto second = core.post("Log", "Line", {"b"}, 0);
  EXPECT_NE(first, second);
  EXPECT_EQ(world.messages.back().session, "s2");
  EXPECT_EQ(world.messages.back().correlation, second);
  EXPECT_EQ(world.messages.back().sinks, std::vector<std::string>{"Log"});
}

TEST_F(Parts, DoNluGetsTheContext) {
  world.components["Grammar"] = {"NLU"};
  core.post("Grammar", "DoNLU", {"hello"}, 0);
  const auto& params = world.messages.back().params;
  ASSERT_EQ(params.size(), 2u);
  ASSERT_TRUE(params[1].if_map());
  EXPECT_EQ(params[1]["now"], core.now);
  core.post("Grammar", "DoNLU", {"hello", "own"}, 0);
  EXPECT_EQ(world.messages.back().params[1], "own");
}

TEST_F(Parts, RaisedEventsHoldTheirTurnUntilTheyAreDropped) {
  const auto turn = core.turns.begin();
  core.raise("Script", "Again", {}, turn);
  EXPECT_TRUE(core.turns.any_open(0));
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(core.one_more_internal_event());
  EXPECT_FALSE(core.one_more_internal_event());
  EXPECT_FALSE(core.turns.any_open(0));
}

// Who handles the error may raise events, too, but is not told again.
TEST_F(Parts, EventsThatChaseEachOtherAreOneError) {
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(core.one_more_internal_event());
  EXPECT_FALSE(core.one_more_internal_event());
  ASSERT_EQ(core.internal.size(), 1u);
  EXPECT_EQ(core.internal.front().message->source, "Script");
  EXPECT_EQ(core.internal.front().message->command, "Error");
  for (int i = 0; i < defaults::internal_events; ++i)
    EXPECT_TRUE(core.one_more_internal_event());
  EXPECT_FALSE(core.one_more_internal_event());
  EXPECT_TRUE(core.internal.empty());
  EXPECT_FALSE(core.one_more_internal_event());
}

TEST_F(Parts, CancellingWhereNothingWaits) {
  EXPECT_TRUE(core.cancel_waits().empty());
}

} // namespace
} // namespace parlour::dialogue
