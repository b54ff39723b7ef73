#include <gtest/gtest.h>

#include "runtime/message/typed_turn.hpp"
#include "script/dialogue/inputs/turn_log.hpp"
#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {
namespace {

Output output(OutputId id, const std::string& text) {
  Output output;
  output.id = id;
  output.text = text;
  return output;
}

class TurnLogTest : public testing::Test {
protected:
  TurnLog log;
  World world{R"xml(<state name="S"/>)xml"};

  void turn(std::uint64_t number) {
    log.take(received(typed_turn("words", number)));
  }
  void dealt_with() {
    log.dealt_with(*world.conversation, world.now);
  }
};

TEST_F(TurnLogTest, KnowsWhatAnswersWhichTurn) {
  log.release(output(1, "Hello."));
  turn(1);
  log.release(output(2, "Yes."));
  dealt_with();
  log.release(output(3, "Are you there?"));
  EXPECT_EQ(log.taken, 1u);
  EXPECT_EQ(log.done, 1u);
  ASSERT_EQ(log.said.size(), 2u);
  EXPECT_EQ(log.said[0].turn, 1u);
  EXPECT_EQ(log.said[0].output, 2u);
  EXPECT_EQ(log.said[1].turn, 0u);
  turn(2);
  EXPECT_TRUE(log.said.empty());
}

TEST_F(TurnLogTest, WhatAnswersAnOpenTurnStays) {
  turn(1);
  log.release(output(1, "Well."));
  turn(2);
  EXPECT_EQ(log.taken, 2u);
  EXPECT_EQ(log.done, 0u);
  EXPECT_EQ(log.said.size(), 1u);
  dealt_with();
  EXPECT_EQ(log.done, 2u);
}

// It may not grow for ever where nobody says anything.
TEST_F(TurnLogTest, KeepsTheNewest) {
  for (OutputId id = 1; id <= 100; ++id)
    log.release(output(id, "Hello?"));
  EXPECT_EQ(log.said.size(), 64u);
  EXPECT_EQ(log.said.back().output, 100u);
}

TEST_F(TurnLogTest, OtherInputsAreNoTurns) {
  log.take(input::Stepped());
  Message message = typed_turn("words", 4);
  message.source = "Robot";
  log.take(received(message));
  EXPECT_EQ(log.taken, 0u);
}

} // namespace
} // namespace parlour::dialogue
