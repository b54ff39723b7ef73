// Classifier assigns texts to labels. It is a linear model (softmax regression)
// over sparse features, trained in memory by stochastic gradient descent. The
// same examples in the same order give the same weights.
//
//  auto classifier = Classifier::train(texts, labels);
//  const auto scores = classifier->scores(text_features(words));
//  const auto probabilities = softmax(scores); // one for each label
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "adapters/nlu/learning/features.hpp"

namespace parlour::adapters::nlu {

struct LabelledText {
  // Made by text_features().
  std::vector<Feature> features;
  std::uint32_t label = 0;
};

// Immutable once trained; any number of threads may use it.
class Classifier {
public:
  Classifier() = default;

  // Trains on all texts. Labels are 0 to `labels` - 1. Returns nothing if that
  // would take more than `max_weights` weights of four bytes. Time: 16 rounds x
  // features of all texts x labels.
  static std::optional<Classifier> train(const std::vector<LabelledText>& texts,
                                         std::uint32_t labels,
                                         std::size_t max_weights = no_limit);

  // For each label, how far the text speaks for it. Features that no example
  // had reduce all scores. softmax() makes probabilities of scores.
  std::vector<float> scores(const std::vector<Feature>& features) const;

  // The share of the text that examples had, 0 to 1, weighted by rarity.
  float known_share(const std::vector<Feature>& features) const;

private:
  struct Input {
    FeatureNumber feature = 0;
    float value = 0;
  };

  void learn_all(const std::vector<LabelledText>& texts);
  void number_features(const std::vector<LabelledText>& texts);
  std::vector<Input> inputs(const std::vector<Feature>& features) const;
  std::vector<float> scores_of(const std::vector<Input>& inputs) const;
  void learn(const std::vector<Input>& inputs, std::uint32_t label, float rate);
  void move(std::size_t row, float by, const std::vector<float>& wrong);

  std::uint32_t labels_ = 0;
  FeatureTable table_;
  // The weight of each feature by how few texts have it (inverse document
  // frequency); the last one is that of features which no text has.
  std::vector<float> rarity_;
  // One row for each feature with a weight for each label; the last row is the
  // bias.
  std::vector<float> weights_;
  // The sum of squared gradients of each row; during training only.
  std::vector<float> moved_;
};

// Scores as probabilities, which sum up to 1.
std::vector<float> softmax(std::vector<float> scores);

} // namespace parlour::adapters::nlu
