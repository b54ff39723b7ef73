#include <gtest/gtest.h>

#include "script/dialogue/frame/frame_evaluator.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

constexpr const char* meeting = R"xml(
  <var name="opening" expr="9"/>
  <topic name="Meeting">
    <slot name="Start" expr="opening + 1"/>
    <slot name="End"/>
    <constraint cond="this.End gt this.Start and this.Start ge opening"
                message="Not from {this.Start} to {this.End} for {_TOPIC}."/>
  </topic>)xml";

struct Evaluation : testing::Test {
  Evaluation() : world(meeting), frame(with_end(12)) {}

  TopicFrame with_end(Value end) const {
    TopicFrame made;
    made.topic = 0;
    made.slots.resize(2);
    made.slots[0].value = 10;
    made.slots[1].value = std::move(end);
    return made;
  }
  const script::Constraint& constraint() const {
    return world.program->topics[0].constraints[0];
  }
  FrameEvaluator evaluator(List variables) const {
    return make_frame_evaluator(
        world.program, std::make_shared<const List>(std::move(variables)), 0);
  }

  World world;
  TopicFrame frame;
};

TEST_F(Evaluation, SeesTheFrameAndTheVariables) {
  auto evaluate = evaluator({9});
  EXPECT_EQ(evaluate(constraint().condition, frame, nullptr).value(), true);
  auto earlier = with_end(8);
  EXPECT_EQ(evaluate(constraint().condition, earlier, nullptr).value(), false);
  auto later = evaluator({11});
  EXPECT_EQ(later(constraint().condition, frame, nullptr).value(), false);
}

TEST_F(Evaluation, NotesWhatIsRead) {
  std::vector<SlotId> reads;
  evaluator({9})(constraint().condition, frame, &reads).value();
  EXPECT_EQ(reads, (std::vector<SlotId>{1, 0, 0}));
}

TEST_F(Evaluation, TextsKnowTheirTopic) {
  auto text = evaluator({9})(constraint().message, frame, nullptr);
  EXPECT_EQ(text.value(), "Not from 10 to 12 for Meeting.");
}

TEST_F(Evaluation, AnErrorIsAValue) {
  auto strange = with_end(List{});
  auto outcome = evaluator({9})(constraint().condition, strange, nullptr);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::type);
}

TEST_F(Evaluation, WithTheSessionsOwnInterpreter) {
  script::Interpreter interpreter(world.program);
  interpreter.set_variable(0, 11);
  auto evaluate = make_frame_evaluator(interpreter, 0);
  EXPECT_EQ(evaluate(constraint().condition, frame, nullptr).value(), false);
}

} // namespace
} // namespace parlour::dialogue
