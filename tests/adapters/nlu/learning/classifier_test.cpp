#include <algorithm>

#include <gtest/gtest.h>

#include "adapters/nlu/learning/classifier.hpp"

namespace parlour::adapters::nlu {
namespace {

std::vector<Feature> features(std::initializer_list<std::string_view> words) {
  std::vector<LearningWord> made;
  for (const auto word : words)
    made.push_back({word, 0});
  return text_features(made);
}

const std::vector<LabelledText>& texts() {
  static const std::vector<LabelledText> all{
      {features({"book", "a", "taxi"}), 0},
      {features({"i", "need", "a", "cab"}), 0},
      {features({"where", "is", "the", "bank"}), 1},
      {features({"is", "there", "a", "bank"}), 1},
      {features({"the"}), 2},
      {features({"i"}), 2}};
  return all;
}

std::size_t best(const std::vector<float>& scores) {
  return static_cast<std::size_t>(std::ranges::max_element(scores) -
                                  scores.begin());
}

TEST(Classifier, LearnsItsExamples) {
  const auto classifier = *Classifier::train(texts(), 3);
  for (const auto& text : texts())
    EXPECT_EQ(best(classifier.scores(text.features)), text.label);
}

TEST(Classifier, TellsWhatIsLikeThem) {
  const auto classifier = *Classifier::train(texts(), 3);
  EXPECT_EQ(best(classifier.scores(features({"taxis", "please"}))), 0U);
  EXPECT_EQ(best(classifier.scores(features({"which", "bank", "is", "it"}))),
            1U);
}

TEST(Classifier, IsTheSameEachTime) {
  const auto asked = features({"a", "cab", "to", "the", "bank"});
  EXPECT_EQ(Classifier::train(texts(), 3)->scores(asked),
            Classifier::train(texts(), 3)->scores(asked));
}

TEST(Classifier, IsLessSureOfWhatItDoesNotKnow) {
  const auto classifier = *Classifier::train(texts(), 3);
  const auto known = softmax(classifier.scores(features({"a", "taxi"})));
  const auto strange = softmax(classifier.scores(
      features({"a", "taxi", "quotes", "philosophical", "poetry"})));
  EXPECT_GT(known[0], strange[0]);
}

TEST(Classifier, KeepsToItsWeights) {
  EXPECT_FALSE(Classifier::train(texts(), 3, 100));
  EXPECT_TRUE(Classifier::train(texts(), 3, 1000));
}

TEST(Softmax, SumsUpToOne) {
  const auto made = softmax({1, 2, 3});
  EXPECT_NEAR(made[0] + made[1] + made[2], 1, 1e-5);
  EXPECT_GT(made[2], made[1]);
  EXPECT_TRUE(softmax({}).empty());
}

} // namespace
} // namespace parlour::adapters::nlu
