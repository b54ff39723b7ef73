#include <gtest/gtest.h>

#include "script/dialogue/frame_evaluator.hpp"
#include "script/dialogue/frames.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

struct FramesOfASession : testing::Test {
  FramesOfASession()
      : world(R"xml(<var name="first" expr="1"/>
          <topic name="Plain"><slot name="A" expr="'a'"/><slot name="B"/>
          </topic>
          <topic name="Bound"><slot name="A"/>
            <constraint cond="this.A ge first" message="no"/></topic>
          <topic name="Range"><slot name="A">
            <cardinality type="range" from="first"/></slot></topic>)xml"),
        interpreter(world.program), frames(*world.program, interpreter) {
    interpreter.set_variable(0, 1);
  }

  static FrameChange set(SlotId slot, Value value) {
    FrameChange change;
    change.slot = slot;
    change.value = std::move(value);
    return change;
  }
  FrameResult at_the_actor(const FrameRequest& request) {
    return apply(*world.program, request.start ? *request.start : *kept,
                 request,
                 make_frame_evaluator(world.program, request.variables, 0));
  }

  World world;
  script::Interpreter interpreter;
  Frames frames;
  FramePointer kept;
};

TEST_F(FramesOfASession, BeginWithInitialValues) {
  EXPECT_EQ(frames.get(0, 0).slots[0].value, "a");
  EXPECT_EQ(frames.get(0, 0).status, TopicStatus::untouched);
}

TEST_F(FramesOfASession, TheFirstRequestBringsTheFrame) {
  frames.change(0, set(1, "b"), 0);
  auto request = frames.request(0, {set(0, "c")}, 5);
  ASSERT_TRUE(request.start);
  EXPECT_EQ(request.start->slots[1].value, "b");
  EXPECT_EQ(request.told, 0u);
  EXPECT_EQ(request.now, 5);
  EXPECT_EQ(request.changes.size(), 1u);
  EXPECT_EQ(request.variables, nullptr);
}

TEST_F(FramesOfASession, LaterOnesTellWhatChangedHere) {
  kept = at_the_actor(frames.request(0, {}, 0)).frame;
  frames.store(kept);
  frames.change(0, set(1, "b"), 0);
  EXPECT_EQ(frames.get(0, 0).slots[1].value, "b");
  auto request = frames.request(0, {set(0, "c")}, 0);
  EXPECT_FALSE(request.start);
  EXPECT_EQ(request.told, 1u);
  auto result = at_the_actor(request);
  EXPECT_EQ(result.frame->slots[1].value, "b");
  EXPECT_EQ(result.reports.size(), 1u);
  frames.store(result.frame);
  EXPECT_EQ(frames.get(0, 0).slots[0].value, "c");
  EXPECT_EQ(frames.request(0, {}, 0).told, 0u);
}

TEST_F(FramesOfASession, VariablesTravelWhereTheyMayBeRead) {
  for (const TopicId topic : {1u, 2u}) {
    auto request = frames.request(topic, {}, 0);
    ASSERT_TRUE(request.variables);
    EXPECT_EQ(*request.variables, List{1});
  }
}

TEST_F(FramesOfASession, ManyChangesTravelAsTheFrame) {
  kept = at_the_actor(frames.request(0, {}, 0)).frame;
  frames.store(kept);
  for (int i = 0; i < 1000; ++i)
    frames.change(0, set(1, i), 0);
  auto request = frames.request(0, {}, 0);
  EXPECT_LT(request.changes.size(), 300u);
  EXPECT_EQ(at_the_actor(request).frame->slots[1].value, 999);
}

} // namespace
} // namespace parlour::dialogue
