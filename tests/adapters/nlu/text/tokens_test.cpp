#include <gtest/gtest.h>

#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu {
namespace {

std::string words(std::string_view text) {
  std::string joined;
  for (const auto& token : tokenize(text).list)
    joined += (joined.empty() ? "" : " ") + token.word;
  return joined;
}

TEST(Tokens, AreWordsInLowerCase) {
  EXPECT_EQ(words("Is there a Coffee-Shop?"), "is there a coffee shop");
  EXPECT_EQ(words("Müller's Café"), "muller cafe");
  EXPECT_EQ(words("10:30am, 9123-4567 #B1-02"), "10:30am 9123-4567 b1-02");
  EXPECT_EQ(words("a.m. o'clock 1,000"), "am oclock 1000");
  EXPECT_EQ(words("mail David.Lee@comptec.com."), "mail david.lee@comptec.com");
}

TEST(Tokens, ExpandContractions) {
  EXPECT_EQ(words("I'm here, what's that? It’s"),
            "i am here what is that it is");
  EXPECT_EQ(words("gimme smth else pls, it ain't here"),
            "give me something else please it is not here");
}

TEST(Tokens, TellAPossessiveFromAVerb) {
  EXPECT_EQ(words("what floor's the bank on"), "what floor is the bank on");
  EXPECT_EQ(words("what time's dinner"), "what time is dinner");
  EXPECT_EQ(words("the toilet's blocked"), "the toilet is blocked");
  EXPECT_EQ(words("That'd be nice"), "that would be nice");
  EXPECT_EQ(words("the children's ward"), "the children ward");
  EXPECT_EQ(words("what, Ho's. The bank"), "what ho the bank");
}

TEST(Tokens, KnowTheirPlace) {
  const std::string text = "to meet  Dr. Ho!";
  const auto tokens = tokenize(text);
  EXPECT_EQ(words_of(text, tokens, 2, 4), "Dr. Ho");
  EXPECT_EQ(words_of(text, tokens, 2, 9), "");
}

TEST(Tokens, KnowTheBreakBefore) {
  const auto tokens = tokenize("Hi, Dr. Ho. Bye").list;
  ASSERT_EQ(tokens.size(), 4U);
  EXPECT_EQ(tokens[1].before, Break::comma);
  EXPECT_EQ(tokens[2].before, Break::none); // the full stop of a title
  EXPECT_EQ(tokens[3].before, Break::sentence);
}

TEST(Tokens, TakeAnyBytes) {
  EXPECT_EQ(words("\xff\xfeyes\xc3\x28no\xe2\x82"), "yes no");
  EXPECT_EQ(words(std::string_view("a\0b", 3)), "a b");
  EXPECT_EQ(words(""), "");
}

TEST(Tokens, AreLimited) {
  const auto many = tokenize(std::string(100'000, 'x') + " y");
  EXPECT_EQ(many.list[0].word.size(), max_word_bytes);
  EXPECT_FALSE(many.truncated);
  std::string text;
  for (std::size_t at = 0; at <= max_tokens; ++at)
    text += "x ";
  EXPECT_EQ(tokenize(text).list.size(), max_tokens);
  EXPECT_TRUE(tokenize(text).truncated);
}

TEST(Tokens, StandInClausesAndSentences) {
  const auto tokens = tokenize("Well, where is it? Tell me, please.");
  const auto clause = stretch_of(tokens, {2, 3}, Break::comma);
  EXPECT_EQ(clause.begin, 1U);
  EXPECT_EQ(clause.end, 4U);
  const auto sentence = stretch_of(tokens, {2, 3}, Break::sentence);
  EXPECT_EQ(sentence.begin, 0U);
  EXPECT_EQ(sentence.end, 4U);
  EXPECT_EQ(stretch_of(tokens, {4, 5}, Break::sentence).end, 7U);
  EXPECT_EQ(stretch_of(tokens, {7, 7}, Break::sentence).begin, 7U);
}

} // namespace
} // namespace parlour::adapters::nlu
