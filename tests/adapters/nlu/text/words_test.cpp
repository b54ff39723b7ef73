#include <gtest/gtest.h>

#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(Words, AreInTheirSets) {
  EXPECT_TRUE(is_title("dr"));
  EXPECT_FALSE(is_title("ho"));
  EXPECT_TRUE(is_determiner("any"));
  EXPECT_TRUE(is_connector("binte"));
  EXPECT_TRUE(is_light("of"));
  EXPECT_FALSE(is_light("shop"));
  EXPECT_TRUE(is_function_word("from"));
  EXPECT_TRUE(is_function_word("the"));
  EXPECT_FALSE(is_function_word("comptec"));
  EXPECT_TRUE(is_asking_word("whom"));
  EXPECT_FALSE(is_asking_word("that"));
  EXPECT_EQ(contraction("i'm"), "i am");
  EXPECT_EQ(contraction("ho"), "");
  EXPECT_EQ(contraction("you've"), "you have");
  EXPECT_EQ(contraction("there'll"), "there will");
  EXPECT_EQ(contraction("didn't"), "did not");
  EXPECT_EQ(contraction("can't"), "can not");
  EXPECT_EQ(contraction("'ve"), "");
}

} // namespace
} // namespace parlour::adapters::nlu
