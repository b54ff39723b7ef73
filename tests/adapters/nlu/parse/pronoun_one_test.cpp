#include <gtest/gtest.h>

#include "adapters/nlu/parse/pronoun_one.hpp"

namespace parlour::adapters::nlu {
namespace {

bool is_number(const char* text, std::size_t at) {
  const Automaton automaton;
  return !is_pronoun_one(make_utterance(text, automaton), at);
}

TEST(PronounOne, IsNoNumberBehindAnAdjective) {
  EXPECT_FALSE(is_number("for the little one", 3));
  EXPECT_FALSE(is_number("one of those", 0));
  EXPECT_FALSE(is_number("this one", 1));
}

TEST(PronounOne, IsANumberElsewhere) {
  EXPECT_TRUE(is_number("in room one", 2));
  EXPECT_TRUE(is_number("the room one", 2));
  EXPECT_TRUE(is_number("one", 0));
  EXPECT_TRUE(is_number("do that at one", 3));
  EXPECT_TRUE(is_number("move this to one", 3));
  EXPECT_TRUE(is_number("the two", 1));
}

} // namespace
} // namespace parlour::adapters::nlu
