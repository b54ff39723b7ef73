#include <algorithm>

#include <gtest/gtest.h>

#include "adapters/nlu/learning/features.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(TextFeatures, AreTheSameForTheSameWords) {
  EXPECT_EQ(text_features({{"book", 0}, {"it", 0}}),
            text_features({{"book", 0}, {"it", 0}}));
  EXPECT_NE(text_features({{"book", 0}, {"it", 0}}),
            text_features({{"it", 0}, {"book", 0}}));
}

TEST(TextFeatures, StandOnceEach) {
  const auto features = text_features({{"bye", 0}, {"bye", 0}});
  EXPECT_EQ(std::ranges::adjacent_find(features), features.end());
}

std::vector<Feature> of_class(FeatureClass wanted,
                              std::vector<Feature> features) {
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

TEST(WordFeatures, AreForEachWordAndTellItsNeighbours) {
  const auto first = word_features({{"from", 0}, {"comptec", 0}});
  const auto second = word_features({{"to", 0}, {"comptec", 0}});
  ASSERT_EQ(first.size(), 2U);
  EXPECT_NE(first[1], second[1]);
  EXPECT_EQ(first[1].size(), second[1].size());
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
