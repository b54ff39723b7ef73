#include <algorithm>

#include <gtest/gtest.h>

#include "adapters/nlu/learning/classifier.hpp"
#include "tests/adapters/nlu/learning/small_vectors.hpp"

namespace parlour::adapters::nlu {
namespace {

TextFeatures features(std::initializer_list<std::string_view> words) {
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
    EXPECT_EQ(best(classifier.read(text.features).scores), text.label);
}

TEST(Classifier, TellsWhatIsLikeThem) {
  const auto classifier = *Classifier::train(texts(), 3);
  EXPECT_EQ(best(classifier.read(features({"taxis", "please"})).scores), 0U);
  EXPECT_EQ(
      best(classifier.read(features({"which", "bank", "is", "it"})).scores),
      1U);
}

TEST(Classifier, IsTheSameEachTime) {
  const auto asked = features({"a", "cab", "to", "the", "bank"});
  EXPECT_EQ(Classifier::train(texts(), 3)->read(asked).scores,
            Classifier::train(texts(), 3)->read(asked).scores);
}

TEST(Classifier, IsLessSureOfWhatItDoesNotKnow) {
  const auto classifier = *Classifier::train(texts(), 3);
  const auto known = classifier.read(features({"a", "taxi"}));
  const auto strange = classifier.read(
      features({"a", "taxi", "quotes", "philosophical", "poetry"}));
  EXPECT_GT(known.scores[0], strange.scores[0]);
  EXPECT_GT(known.known, 0.8F);
  EXPECT_LT(strange.known, 0.5F);
}

TEST(Classifier, PullsLabelsApart) {
  const auto classifier = *Classifier::train(texts(), 3);
  for (const auto& text : texts()) {
    const auto scores = classifier.read(text.features).scores;
    for (std::uint32_t label = 0; label < 3; ++label)
      EXPECT_EQ(scores[label] > 0, label == text.label) << label;
  }
}

TEST(Classifier, TellsOtherWordsByWhatTheyMean) {
  const auto vectors = test::small_vectors();
  const auto text = [&](std::initializer_list<std::string_view> words) {
    std::vector<LearningWord> made;
    for (const auto word : words)
      made.push_back({word, 0, vectors->find(word)});
    return text_features(made);
  };
  const auto classifier = *Classifier::train(
      {{text({"a", "taxi"}), 0}, {text({"the", "bank"}), 1}}, 2);
  EXPECT_GT(classifier.read(text({"cab"})).scores[0], 0);
  EXPECT_LT(classifier.read(text({"cab"})).scores[1], 0);
  EXPECT_LT(classifier.read(features({"cab"})).scores[0],
            classifier.read(text({"cab"})).scores[0]);
}

TEST(Classifier, TellsOtherWordsByWhatTheSentenceMeans) {
  const auto text = [](std::initializer_list<std::string_view> words,
                       std::vector<float> sentence) {
    auto made = features(words);
    made.sentence = std::move(sentence);
    return made;
  };
  const std::vector<LabelledText> examples{
      {text({"a", "taxi"}, {0.8F, 0.6F}), 0},
      {text({"the", "bank"}, {0.6F, -0.8F}), 1}};
  const auto by_sentences =
      *Classifier::train(examples, 2, no_limit, Evidence::sentences);
  const auto other = text({"cab"}, {0.7F, 0.7F});
  EXPECT_GT(by_sentences.read(other).scores[0], 0);
  EXPECT_LT(by_sentences.read(other).scores[1], 0);
  // Without one, the words alone speak.
  EXPECT_LT(by_sentences.read(features({"cab"})).scores[0],
            by_sentences.read(other).scores[0]);
  const auto by_words = *Classifier::train(examples, 2);
  EXPECT_EQ(by_words.read(other).scores,
            by_words.read(features({"cab"})).scores);
}

TEST(Classifier, KeepsToItsWeights) {
  EXPECT_FALSE(Classifier::train(texts(), 3, 100));
  EXPECT_TRUE(Classifier::train(texts(), 3, 1000));
}

} // namespace
} // namespace parlour::adapters::nlu
