// What statements know of the script that they are in, and what they ask for.
#include <gtest/gtest.h>

#include "runtime/base/defaults.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct RunningScriptTest : testing::Test {
  RunningScriptTest()
      : world("<state name='A'/><state name='B'/>"), interpreter(world.program),
        context(interpreter, world.program, {}, world), inbox(context.turns),
        messenger(context, inbox), running(context, messenger) {
    running.begins(7, {.visit = 3});
  }
  World world;
  script::Interpreter interpreter;
  DialogueContext context;
  Inbox inbox;
  Messenger messenger;
  RunningScript running;
};

TEST_F(RunningScriptTest, WhatABodyDidIsKnownUntilItRunsAgain) {
  running.redirect();
  running.acts();
  running.begins(8, {});
  EXPECT_TRUE(running.redirected(7));
  EXPECT_TRUE(running.acted(7));
  EXPECT_FALSE(running.acted(8));
  running.begins(7, {});
  EXPECT_FALSE(running.redirected(7));
  EXPECT_FALSE(running.acted(7));
  EXPECT_EQ(running.deeds(), 1u);
}

TEST_F(RunningScriptTest, AWaitIsTakenOnce) {
  const auto id = running.begin_wait(WaitFor::time);
  const auto wait = running.take_wait();
  EXPECT_EQ(wait.id, id);
  EXPECT_EQ(wait.what, WaitFor::time);
  EXPECT_EQ(running.take_wait().id, 0u);
}

TEST_F(RunningScriptTest, OneThatGoesOnHasWhatItAskedForBefore) {
  running.later(steps::Restart{});
  auto later = running.take_later();
  running.begins(8, {});
  EXPECT_TRUE(running.hand_over().empty());
  running.goes_on(7, {.visit = 3}, std::move(later));
  EXPECT_EQ(running.body(), 7u);
  EXPECT_EQ(running.origin().visit, 3u);
  EXPECT_FALSE(running.hand_over().empty());
}

TEST_F(RunningScriptTest, OfSeveralTransitsTheLastCounts) {
  running.later(steps::Transit{0, {}});
  running.later(steps::Transit{1, {}});
  EXPECT_TRUE(running.leaves_its_state());
  const auto steps = running.hand_over();
  ASSERT_EQ(std::distance(steps.begin(), steps.end()), 1);
  EXPECT_EQ(std::get<steps::Transit>(*steps.begin()).state, 1u);
  EXPECT_FALSE(running.leaves_its_state());
}

TEST_F(RunningScriptTest, WhatIsTooMuchIsDroppedAndWhoPushedIsTold) {
  for (int i = 0; i < defaults::internal_events; ++i)
    messenger.one_more_internal_event();
  const auto wait = running.begin_wait(WaitFor::user);
  running.later(steps::Push{.state = 0, .wait = wait});
  EXPECT_TRUE(running.hand_over().empty());
  EXPECT_NE(context.lane.next(), nullptr);
}

} // namespace
} // namespace parlour::dialogue
