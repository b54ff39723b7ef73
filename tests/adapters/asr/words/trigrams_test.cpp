#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/trigrams.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::HasSubstr;
using testing::Not;

class TrigramsTest : public testing::Test {
protected:
  TrigramCounts counted() const {
    TrigramCounts counts;
    counts.add({tea, please});
    counts.add({coffee, please}, 2);
    counts.add({tea});
    return counts;
  }

  Symbols symbols;
  const Symbol tea = symbols.word("tea");
  const Symbol coffee = symbols.word("coffee");
  const Symbol please = symbols.word("please");
  const Trigrams trigrams{counted()};
};

TEST_F(TrigramsTest, ProbabilitiesSumToOne) {
  for (const auto last : {sentence_begin, tea, coffee, please}) {
    double sum = 0;
    for (const auto word : {tea, coffee, please, sentence_end})
      sum += trigrams.probability(sentence_begin, last, word);
    EXPECT_NEAR(sum, 1, 1e-9);
  }
}

TEST_F(TrigramsTest, WhatWasSaidIsMoreProbable) {
  EXPECT_GT(trigrams.probability(sentence_begin, coffee, please),
            trigrams.probability(sentence_begin, coffee, tea));
  EXPECT_GT(trigrams.probability(sentence_begin, sentence_begin, tea),
            trigrams.probability(sentence_begin, sentence_begin, please));
  EXPECT_GT(trigrams.probability(sentence_begin, coffee, tea), 0);
}

TEST_F(TrigramsTest, AreWrittenAsArpa) {
  const auto text = trigrams.arpa(symbols);
  EXPECT_THAT(text, HasSubstr("ngram 1=5\nngram 2=6\nngram 3=5\n"));
  EXPECT_THAT(text, HasSubstr("-99.0000 <s> "));
  EXPECT_THAT(text, HasSubstr(" <s> coffee please\n"));
  EXPECT_THAT(text, HasSubstr("\\end\\\n"));
}

TEST_F(TrigramsTest, WhatIsSeldomIsLeftToThePairs) {
  const Trigrams seldom(counted(), 2);
  EXPECT_THAT(seldom.arpa(symbols), Not(HasSubstr("<s> tea please\n")));
  EXPECT_THAT(seldom.arpa(symbols), HasSubstr("<s> coffee please\n"));
  EXPECT_GT(seldom.probability(sentence_begin, tea, please), 0);
  EXPECT_LT(seldom.probability(sentence_begin, tea, please),
            trigrams.probability(sentence_begin, tea, please));
}

TEST_F(TrigramsTest, WordsOfOneNameAreCountedTogether) {
  const auto one = counted().renamed(
      [&](Symbol symbol) { return symbol == coffee ? tea : symbol; });
  EXPECT_EQ(one.triples().size(), 4u);
  EXPECT_EQ(Trigrams(one).words().rows.front().times, 4);
}

TEST_F(TrigramsTest, EachTripleIsThereOnce) {
  auto counts = counted();
  counts.add({tea});
  const auto before = counts.triples();
  counts.unite();
  EXPECT_EQ(counts.triples().size(), before.size());
  EXPECT_EQ(before.size(), 7u);
  EXPECT_TRUE(TrigramCounts().triples().empty());
}

} // namespace
} // namespace parlour::adapters::asr
