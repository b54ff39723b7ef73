#include <gtest/gtest.h>

#include "script/dialogue/context/waits.hpp"
#include "script/program/computing_host.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct WaitsTest : testing::Test, ActivationRunner::Listener, Waits::Others {
  WaitsTest()
      : world(""), interpreter(world.program),
        context(interpreter, world.program, {}, world), timers(world),
        inbox(context.turns), messenger(context, inbox),
        runner(context, interpreter, messenger, timers, host, *this),
        waits(context, runner, *this) {}

  void wait_is_over(WaitId) override {}
  void body_failed(TopicId, CodeId) override {}
  void resume_in_pipeline(WaitId wait, Expected<Value>) override {
    resumed.push_back(wait);
  }
  std::vector<WaitId> waits_in_pipeline() const override {
    return {9};
  }
  void forget_request(WaitId wait) override {
    forgotten.push_back(wait);
  }
  // A script of the dialogue lane waits.
  void wait_in_lane(WaitId wait) {
    context.lane.queue(steps::Conclude{});
    context.lane.next();
    context.lane.wait(wait, Lane::Others::go_on);
  }

  World world;
  script::Interpreter interpreter;
  DialogueContext context;
  Timers timers;
  Inbox inbox;
  Messenger messenger;
  script::ComputingHost host{"a test", 0};
  ActivationRunner runner;
  Waits waits;
  std::vector<WaitId> resumed;
  std::vector<WaitId> forgotten;
};

TEST_F(WaitsTest, WhatWaitsInTheLaneGoesOnThere) {
  wait_in_lane(5);
  waits.resume(5, Value("yes"));
  const auto* step = context.lane.next();
  ASSERT_NE(step, nullptr);
  ASSERT_TRUE(is<steps::ResumeWait>(*step));
  EXPECT_EQ(std::get<steps::ResumeWait>(*step).wait, 5u);
  EXPECT_TRUE(resumed.empty());
  EXPECT_EQ(forgotten, std::vector<WaitId>{5});
}

TEST_F(WaitsTest, AllElseGoesOnInThePipeline) {
  waits.resume(9, Value());
  EXPECT_EQ(resumed, std::vector<WaitId>{9});
}

// In the pipeline only those that wait for the user, which 9 does not.
TEST_F(WaitsTest, CancelledAreThoseOfTheLaneButSome) {
  wait_in_lane(5);
  wait_in_lane(6);
  const auto steps = waits.cancel({5});
  ASSERT_EQ(std::distance(steps.begin(), steps.end()), 1);
  const auto& first = std::get<steps::ResumeWait>(*steps.begin());
  EXPECT_EQ(first.wait, 6u);
  EXPECT_EQ(first.outcome->error().kind, ErrorKind::cancelled);
  EXPECT_TRUE(context.lane.waits(5));
  EXPECT_EQ(forgotten, std::vector<WaitId>{6});
}

} // namespace
} // namespace parlour::dialogue
