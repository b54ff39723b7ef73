#include <gtest/gtest.h>

#include "runtime/message/typed_turn.hpp"

namespace parlour {
namespace {

TEST(TypedTurn, IsWhatARecogniserWouldSay) {
  const auto turn = typed_turn("hello");
  EXPECT_EQ(turn.source, "ASR");
  EXPECT_EQ(turn.command, "RecognitionResult");
  EXPECT_EQ(turn.params, (std::vector<Value>{"hello", 1}));
  EXPECT_EQ(number_of_turn(turn), 0);
}

TEST(TypedTurn, CarriesItsNumber) {
  EXPECT_EQ(number_of_turn(typed_turn("hello", 7)), 7);
  EXPECT_EQ(typed_turn("hello", 7).params.at(0), Value("hello"));
}

TEST(TypedTurn, OnlyOfATurnANumberIsTaken) {
  auto other = typed_turn("hello", 7);
  other.command = "Partial";
  EXPECT_EQ(number_of_turn(other), 0);
  other = typed_turn("hello", 7);
  other.source = "Robot";
  EXPECT_EQ(number_of_turn(other), 0);
  other = typed_turn("hello", 7);
  other.params.back() = "7";
  EXPECT_EQ(number_of_turn(other), 0);
  other.params.back() = -7;
  EXPECT_EQ(number_of_turn(other), 0);
}

} // namespace
} // namespace parlour
