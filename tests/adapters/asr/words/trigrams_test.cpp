#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/trigrams.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::HasSubstr;
using testing::Not;

class TrigramsTest : public testing::Test {
protected:
  Trigrams counted() const {
    TrigramCounts counts;
    counts.add({tea, please});
    counts.add({coffee, please}, 2);
    counts.add({tea});
    return Trigrams(counts);
  }

  Symbols symbols;
  const Symbol tea = symbols.word("tea");
  const Symbol coffee = symbols.word("coffee");
  const Symbol please = symbols.word("please");
  const Trigrams trigrams = counted();
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
  EXPECT_THAT(text, HasSubstr("-99 <s> "));
  EXPECT_THAT(text, HasSubstr(" <s> coffee please\n"));
  EXPECT_THAT(text, HasSubstr("\\end\\\n"));
  EXPECT_THAT(trigrams.arpa(symbols, 2), Not(HasSubstr("<s> tea please\n")));
}

} // namespace
} // namespace parlour::adapters::asr
