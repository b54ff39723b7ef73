// The topics of a conversation: a change is inspected, and a topic that ends
// does so in its frame and in the order.
#include <gtest/gtest.h>

#include "script/dialogue/context/topic_frames.hpp"
#include "tests/script/dialogue/topics_of_tests.hpp"

namespace parlour::dialogue {
namespace {

TEST(TopicFrames, WhatBecameOfASlotAndATopicIsShown) {
  World world(booking);
  world.say(inform("Booking", {{"Place", "Hall"}}));
  EXPECT_EQ(world.seen(InspectionKind::slot),
            Texts{"Booking.Place: Hall (accepted)"});
  world.say("cancel");
  EXPECT_EQ(world.seen(InspectionKind::topic),
            (Texts{"Booking: active", "Booking: cancelled"}));
}

struct Topics : testing::Test {
  Topics()
      : world("<topic name='T'><slot name='S'/></topic>"),
        interpreter(world.program),
        context(interpreter, world.program, {}, world),
        frames(context, interpreter) {
    frames.order().activate(0);
    frames.set_status(0, TopicStatus::active);
    frames.change(0, {.kind = FrameChange::Kind::set, .slot = 0, .value = 1});
  }
  World world;
  script::Interpreter interpreter;
  DialogueContext context;
  TopicFrames frames;
};

TEST_F(Topics, ATopicThatIsCompletedIsNotTheCurrentOne) {
  frames.complete(0);
  EXPECT_EQ(frames[0].status, TopicStatus::completed);
  EXPECT_EQ(frames[0].slots[0].value, 1);
  EXPECT_FALSE(frames.order().current());
}

TEST_F(Topics, ATopicThatIsCancelledIsEmpty) {
  frames.cancel(0);
  EXPECT_EQ(frames[0].status, TopicStatus::cancelled);
  EXPECT_TRUE(frames[0].slots[0].value.is_unknown());
  EXPECT_FALSE(frames.order().current());
}

TEST_F(Topics, AnEnquiryThatIsAnsweredIsContextForAWhile) {
  frames.answered(0);
  EXPECT_EQ(frames[0].status, TopicStatus::resting);
  EXPECT_EQ(frames.resting(), 0u);
  context.now += 3'600'000;
  EXPECT_FALSE(frames.resting());
}

TEST_F(Topics, AllBeginAnew) {
  frames.restart();
  EXPECT_EQ(frames[0].status, TopicStatus::untouched);
  EXPECT_FALSE(frames.order().current());
}

} // namespace
} // namespace parlour::dialogue
