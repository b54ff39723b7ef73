#include <numeric>

#include <gtest/gtest.h>

#include "adapters/nlu/learning/certainty.hpp"

namespace parlour::adapters::nlu {
namespace {

// A reading that is as sure of label 1 as `score` says.
TextReading reading(float score, float known = 1) {
  return {{-1, score, -1}, known};
}

float probability(const Certainty& certainty, const TextReading& reading) {
  return certainty.probabilities(reading)[1];
}

TEST(Certainty, LeavesSomethingForNothing) {
  const auto all = Certainty().probabilities(reading(0.5F));
  EXPECT_GT(all[1], 0.8F);
  EXPECT_LT(std::accumulate(all.begin(), all.end(), 0.0F), 1);
  EXPECT_TRUE(Certainty().probabilities({}).empty());
}

TEST(Certainty, GrowsWithTheScoreAndWithWhatIsKnown) {
  const Certainty certainty;
  EXPECT_GT(probability(certainty, reading(0.5F)),
            probability(certainty, reading(-0.5F)));
  EXPECT_GT(probability(certainty, reading(0.5F)),
            probability(certainty, reading(0.5F, 0.1F)));
}

// Texts that score from -1 to 0.98, of which every second is told wrong.
std::vector<HeldOutText> held_out() {
  std::vector<HeldOutText> made;
  for (std::uint32_t at = 0; at < 100; ++at)
    made.push_back(
        {reading(-1 + 0.02F * static_cast<float>(at)), at % 2 == 0 ? 1U : 0U});
  return made;
}

TEST(Certainty, LetsThroughWhatIsToldRight) {
  const Certainty certainty(held_out(), 0.4);
  int through = 0;
  for (const auto& text : held_out())
    if (text.label == 1)
      through += probability(certainty, text.reading) >= 0.4F ? 1 : 0;
  // 39 of 40, and one text in 50 tells little.
  EXPECT_GE(through, 48);
  EXPECT_LE(through, 50);
}

TEST(Certainty, StaysAProbability) {
  for (const auto& certainty :
       {Certainty(held_out(), 0.9), Certainty::of_many(Evidence::words)})
    for (const float score : {-1.0F, 0.0F, 1.0F, 3.0F})
      EXPECT_LE(probability(certainty, reading(score)), 1);
}

// The more was learnt, the lower are scores, and the more tell unknown words.
TEST(Certainty, OfManyIsSurerOfALowScoreIfTheWordsAreKnown) {
  const auto many = Certainty::of_many(Evidence::words);
  EXPECT_GT(probability(many, reading(-0.2F)),
            probability(Certainty(), reading(-0.2F)));
  EXPECT_LT(probability(many, reading(-0.7F, 0.1F)),
            probability(many, reading(-0.7F)) / 2);
}

TEST(Certainty, OfManyDoubtsMoreBesideSentences) {
  EXPECT_LT(
      probability(Certainty::of_many(Evidence::sentences), reading(-0.2F)),
      probability(Certainty::of_many(Evidence::words), reading(-0.2F)));
}

} // namespace
} // namespace parlour::adapters::nlu
