#include <gtest/gtest.h>

#include "adapters/nlu/learning/tagger.hpp"

namespace parlour::adapters::nlu {
namespace {

constexpr std::uint32_t visitor = 0;
constexpr std::uint32_t firm = 1;

std::vector<std::vector<Feature>>
features(std::initializer_list<std::string_view> words) {
  std::vector<LearningWord> made;
  for (const auto word : words)
    made.push_back({word, 0});
  return word_features(made);
}

const std::vector<TaggedText>& texts() {
  static const std::vector<TaggedText> all{
      {features({"i", "am", "david", "from", "comptec"}),
       {outside, outside, begins(visitor), outside, begins(firm)},
       {visitor, firm}},
      {features({"my", "name", "is", "mary", "ann"}),
       {outside, outside, outside, begins(visitor), goes_on(visitor)},
       {visitor, firm}},
      {features({"i", "am", "from", "acme"}),
       {outside, outside, outside, begins(firm)},
       {visitor, firm}},
      {features({"this", "is", "paul", "from", "initech"}),
       {outside, outside, begins(visitor), outside, begins(firm)},
       {visitor, firm}},
      {features({"i", "am", "lena", "from", "hooli"}),
       {outside, outside, begins(visitor), outside, begins(firm)},
       {visitor, firm}}};
  return all;
}

TEST(Tagger, LearnsItsExamples) {
  const auto tagger = *Tagger::train(texts(), 2);
  for (const auto& text : texts())
    EXPECT_EQ(tagger.tag(text.features, text.slots), text.labels);
}

TEST(Tagger, FindsOtherWordsInTheSamePlaces) {
  const auto tagger = *Tagger::train(texts(), 2);
  EXPECT_EQ(tagger.tag(features({"i", "am", "wendy", "from", "globex"}),
                       {visitor, firm}),
            (std::vector<TagLabel>{outside, outside, begins(visitor), outside,
                                   begins(firm)}));
}

TEST(Tagger, KeepsToTheSlotsAllowed) {
  const auto tagger = *Tagger::train(texts(), 2);
  for (const auto label : tagger.tag(texts()[0].features, {firm}))
    EXPECT_TRUE(label == outside || slot_of(label) == firm);
  EXPECT_EQ(tagger.tag(texts()[2].features, {}),
            std::vector<TagLabel>(4, outside));
}

TEST(Tagger, PutsInARowWhatItSawInARow) {
  // In no text does one firm follow another, but in each label "x" is likely.
  const auto tagger =
      *Tagger::train({{features({"x"}), {begins(firm)}, {firm}},
                      {features({"x", "to"}), {begins(firm), outside}, {firm}},
                      {features({"x"}), {begins(firm)}, {firm}}},
                     2);
  EXPECT_EQ(tagger.tag(features({"x", "x"}), {firm}).front(), begins(firm));
  EXPECT_NE(tagger.tag(features({"x", "x"}), {firm}).back(), begins(firm));
}

TEST(Tagger, KeepsToItsWeights) {
  EXPECT_FALSE(Tagger::train(texts(), 2, 500));
  EXPECT_TRUE(Tagger::train(texts(), 2, 5000));
}

TEST(Tagger, TakesNothingToTag) {
  EXPECT_TRUE(Tagger().tag({}, {}).empty());
  EXPECT_EQ(Tagger().tag(features({"x"}), {}), std::vector<TagLabel>{outside});
}

} // namespace
} // namespace parlour::adapters::nlu
