#include <gtest/gtest.h>

#include "adapters/nlu/forms/number_words.hpp"

namespace parlour::adapters::nlu {
namespace {

// "value" or "value." for an ordinal, with the tokens taken.
std::string read(const char* text) {
  const auto found = number_at(tokenize(text), 0);
  if (!found)
    return "none";
  return std::to_string(found->value) + (found->ordinal ? "." : "") + "/" +
         std::to_string(found->length);
}

TEST(NumberWords, AreSummedUp) {
  EXPECT_EQ(read("twenty three"), "23/2");
  EXPECT_EQ(read("twenty third floor"), "23./2");
  EXPECT_EQ(read("two hundred and five"), "205/4");
  EXPECT_EQ(read("one thousand two hundred"), "1200/4");
  EXPECT_EQ(read("23rd"), "23./1");
  EXPECT_EQ(read("zero"), "0/1");
}

TEST(NumberWords, EndWhereTheNextDoesNotFit) {
  EXPECT_EQ(read("ten thirty"), "10/1");
  EXPECT_EQ(read("three four"), "3/1");
  EXPECT_EQ(read("twenty eleven"), "20/1");
  EXPECT_EQ(read("five, six"), "5/1");
  EXPECT_EQ(read("three and four"), "3/1");
  EXPECT_EQ(read("banana"), "none");
}

TEST(NumberWords, KnowDigits) {
  EXPECT_EQ(digit_of("oh"), 0);
  EXPECT_EQ(digit_of("nine"), 9);
  EXPECT_FALSE(digit_of("ten"));
  EXPECT_EQ(digits_of("0042"), 42);
  EXPECT_FALSE(digits_of("4x"));
}

} // namespace
} // namespace parlour::adapters::nlu
