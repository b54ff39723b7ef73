#include <gtest/gtest.h>

#include "adapters/asr/words/spoken_words.hpp"

namespace parlour::adapters::asr {
namespace {

std::string said(std::string_view text) {
  std::string all;
  for (const auto& word : spoken_words(text))
    all += (all.empty() ? "" : " ") + word;
  return all;
}

TEST(SpokenWordsTest, AreThoseThatAreSaid) {
  EXPECT_EQ(said("I am Dr. Jeffery Ho, from R&D!"),
            "i am doctor jeffery ho from r and d");
  EXPECT_EQ(said("What's the time?"), "what's the time");
  EXPECT_EQ(said("10:30am"), "ten thirty a.m.");
  EXPECT_EQ(said("at 9:05 PM please"), "at nine oh five p.m. please");
  EXPECT_EQ(said("14:00"), "fourteen o'clock");
  EXPECT_EQ(said("10 am, I am here"), "ten a.m. i am here");
  EXPECT_EQ(said("the 23rd floor"), "the twenty third floor");
  EXPECT_EQ(said("in 115 minutes"), "in one hundred fifteen minutes");
  EXPECT_EQ(said("call 64785056"),
            "call six four seven eight five zero five six");
  EXPECT_EQ(said("?! --"), "");
  EXPECT_EQ(said(""), "");
}

TEST(SpokenWordsTest, NumbersAndOrdinals) {
  EXPECT_EQ(number_in_words(2'300'001),
            (std::vector<std::string>{"two", "million", "three", "hundred",
                                      "thousand", "one"}));
  EXPECT_EQ(ordinal_in_words(30), std::vector<std::string>{"thirtieth"});
  EXPECT_EQ(ordinal_in_words(12), std::vector<std::string>{"twelfth"});
}

} // namespace
} // namespace parlour::adapters::asr
