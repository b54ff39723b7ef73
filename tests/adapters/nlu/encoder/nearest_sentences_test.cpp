#include <gmock/gmock.h>

#include "adapters/nlu/encoder/nearest_sentences.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;
using testing::FloatEq;

TEST(NearestSentences, TellsTheMostSimilarOfEachLabel) {
  NearestSentences sentences;
  sentences.add({1, 0}, 0);
  sentences.add({0.6F, 0.8F}, 0);
  sentences.add({0, -1}, 2);
  EXPECT_THAT(sentences.find({0, 1}, 4), ElementsAre(FloatEq(0.8F), 0, 0, 0));
  EXPECT_THAT(sentences.find({1, 0}, 3), ElementsAre(1, 0, 0));
  EXPECT_THAT(sentences.find({0, -1}, 3), ElementsAre(0, 0, 1));
}

TEST(NearestSentences, KnowsNothingOfOthers) {
  NearestSentences sentences;
  EXPECT_THAT(sentences.find({1, 0}, 1), ElementsAre(0));
  sentences.add({1, 0}, 5);
  EXPECT_THAT(sentences.find({1, 0}, 1), ElementsAre(0));
  EXPECT_THAT(sentences.find({}, 6), testing::Each(0));
}

} // namespace
} // namespace parlour::adapters::nlu
