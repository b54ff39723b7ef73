// A linear classifier (softmax regression) over the features of texts, trained
// in memory: the same examples in the same order give the same weights.
// Immutable once trained; any number of threads may ask it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "adapters/nlu/learning/features.hpp"

namespace parlour::adapters::nlu {

struct LabelledText {
  std::vector<Feature> features; // text_features
  std::uint32_t label = 0;
};

class Classifier {
public:
  Classifier() = default;

  // Labels are 0 to labels - 1. Nothing where that would take more than so many
  // weights, of four bytes each.
  static std::optional<Classifier> train(const std::vector<LabelledText>& texts,
                                         std::uint32_t labels,
                                         std::size_t most_weights = no_limit);

  // For each label how far the text speaks for it. What no example had takes
  // its share away from all.
  std::vector<float> scores(const std::vector<Feature>& features) const;

  // How much of the text examples had, 0 to 1.
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
  std::vector<float> rarity_;  // of features; the last one of unknown ones
  std::vector<float> weights_; // a row of labels for each feature, and biases
  std::vector<float> moved_;   // how far each row was, squared; in training
};

// Scores as probabilities, which sum up to 1.
std::vector<float> softmax(std::vector<float> scores);

} // namespace parlour::adapters::nlu
