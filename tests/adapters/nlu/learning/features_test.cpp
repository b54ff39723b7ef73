#include <algorithm>

#include <gmock/gmock.h>

#include "adapters/nlu/learning/features.hpp"
#include "tests/adapters/nlu/learning/small_vectors.hpp"

namespace parlour::adapters::nlu {
namespace {

using test::small_vectors;
using testing::ElementsAre;
using testing::FloatNear;
using testing::IsEmpty;

TEST(TextFeatures, AreTheSameForTheSameWords) {
  EXPECT_EQ(text_features({{"book", 0}, {"it", 0}}),
            text_features({{"book", 0}, {"it", 0}}));
  EXPECT_NE(text_features({{"book", 0}, {"it", 0}}),
            text_features({{"it", 0}, {"book", 0}}));
}

TEST(TextFeatures, AreThoseOfWordsThatMeanSomething) {
  LearningWord please{"please", 0};
  please.filler = true;
  EXPECT_EQ(text_features({{"book", 0}, please, {"it", 0}}),
            text_features({{"book", 0}, {"it", 0}}));
  please.kind = 9; // a value's
  EXPECT_NE(text_features({{"book", 0}, please, {"it", 0}}),
            text_features({{"book", 0}, {"it", 0}}));
}

TEST(TextFeatures, StandOnceEach) {
  const auto features = text_features({{"bye", 0}, {"bye", 0}}).features;
  EXPECT_EQ(std::ranges::adjacent_find(features), features.end());
}

std::vector<Feature> of_class(FeatureClass wanted, const TextFeatures& text) {
  auto features = text.features;
  std::erase_if(features, [&](Feature one) { return class_of(one) != wanted; });
  return features;
}

TEST(TextFeatures, HaveTheKindOfAValueAndItsWords) {
  const auto ho = text_features({{"meet", 0}, {"jeffery", 9}, {"ho", 9}});
  const auto tan = text_features({{"meet", 0}, {"tan", 9}});
  const auto bank = text_features({{"meet", 0}, {"tan", 8}});
  for (const auto one : {FeatureClass::plain, FeatureClass::kind_of_value}) {
    EXPECT_EQ(of_class(one, ho), of_class(one, tan));
    EXPECT_NE(of_class(one, tan), of_class(one, bank));
  }
  EXPECT_EQ(of_class(FeatureClass::kind_of_value, ho).size(), 1U);
  EXPECT_EQ(of_class(FeatureClass::word_of_value, ho).size(), 2U);
  EXPECT_EQ(of_class(FeatureClass::word_of_value, tan),
            of_class(FeatureClass::word_of_value, bank));
}

TEST(TextFeatures, HaveTheMeaningOfAllWordsButThoseOfValues) {
  const auto vectors = small_vectors();
  const auto meaning = [&](std::string_view word, std::uint32_t kind) {
    return text_features({{word, kind, vectors->find(word)}}).meaning;
  };
  EXPECT_THAT(meaning("cab", 0),
              ElementsAre(FloatNear(0.6F, 0.02F), FloatNear(0.8F, 0.02F)));
  EXPECT_THAT(meaning("cab", 3), IsEmpty());
  EXPECT_THAT(meaning("unheard-of", 0), IsEmpty());
  // "bank" points elsewhere and counts half.
  EXPECT_THAT(text_features({{"cab", 0, vectors->find("cab")},
                             {"bank", 0, vectors->find("bank")}})
                  .meaning,
              ElementsAre(FloatNear(0.89F, 0.02F), FloatNear(0.45F, 0.02F)));
}

TEST(WordFeatures, AreForEachWordAndTellItsNeighbours) {
  const auto first = word_features({{"from", 0}, {"comptec", 0}});
  const auto second = word_features({{"to", 0}, {"comptec", 0}});
  ASSERT_EQ(first.size(), 2U);
  EXPECT_NE(first[1], second[1]);
  EXPECT_EQ(first[1].size(), second[1].size());
}

TEST(WordFeatures, TellTheGroupsOfTheWordsAround) {
  const auto vectors = small_vectors();
  const auto features_of = [&](std::string_view word) {
    return word_features({{"a", 0}, {word, 0, vectors->find(word)}})[0];
  };
  const auto common = [&](std::string_view left, std::string_view right) {
    const auto all = features_of(right);
    return std::ranges::count_if(features_of(left), [&](Feature one) {
      return std::ranges::find(all, one) != all.end();
    });
  };
  // In both groups, in one of two, in none.
  EXPECT_EQ(common("taxi", "cab"), common("taxi", "train") + 1);
  EXPECT_EQ(common("taxi", "train"), common("taxi", "bank") + 1);
}

TEST(FeatureTable, NumbersInOrder) {
  FeatureTable table;
  EXPECT_EQ(table.add(70), 0U);
  EXPECT_EQ(table.add(7), 1U);
  EXPECT_EQ(table.add(70), 0U);
  EXPECT_EQ(table.find(7), 1U);
  EXPECT_EQ(table.find(8), no_feature);
}

} // namespace
} // namespace parlour::adapters::nlu
