#include <gtest/gtest.h>

#include "script/dialogue/context/dialogue_context.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct Context : testing::Test {
  Context()
      : world("<state name='A'/>"), interpreter(world.program),
        context(interpreter, world.program, {}, world) {}
  World world;
  script::Interpreter interpreter;
  DialogueContext context;
};

TEST_F(Context, IdsAreNeverGivenTwice) {
  const auto first = context.next_id();
  EXPECT_NE(context.next_id(), first);
  EXPECT_NE(first, 0u);
}

TEST_F(Context, AtFirstThereIsNoActiveState) {
  EXPECT_EQ(context.active_state(), nullptr);
  context.states.enter(world.program->state("A"));
  ASSERT_NE(context.active_state(), nullptr);
  EXPECT_EQ(context.active_state()->name, "A");
}

TEST_F(Context, ASeatMayCloseSoonerOrLater) {
  WorldOptions of_world;
  of_world.sessions = "closes-after='30s'";
  of_world.settings =
      "<seat name='desk' closes-after='5s'/><seat name='hall'/>";
  World seats("<state name='A'/>", of_world);
  const script::Interpreter its(seats.program);
  const auto closes_after = [&](const std::string& seat) {
    ConversationOptions options;
    options.seat = seat;
    return DialogueContext(its, seats.program, options, seats)
        .closes_after()
        .count();
  };
  EXPECT_EQ(closes_after("desk"), 5'000);
  EXPECT_EQ(closes_after("hall"), 30'000);
  EXPECT_EQ(closes_after(""), 30'000);
  EXPECT_EQ(closes_after("gone"), 30'000);
}

TEST_F(Context, WhatIsInspectedGoesToThePort) {
  context.inspect(InspectionKind::log, "info", "a line");
  EXPECT_EQ(world.seen(InspectionKind::log), Texts{"info: a line"});
}

} // namespace
} // namespace parlour::dialogue
