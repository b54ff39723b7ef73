// Classifier assigns texts to labels. It is linear: for each label a support
// vector machine that tells its texts from all others (squared hinge loss),
// trained in memory. The same examples in the same order give the same weights.
//
//  auto classifier = Classifier::train(texts, labels);
//  const auto reading = classifier->read(text_features(words));
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "adapters/nlu/learning/features.hpp"

namespace parlour::adapters::nlu {

struct LabelledText {
  // Made by text_features().
  TextFeatures features;
  std::uint32_t label = 0;
};

// What a classifier says of a text.
struct TextReading {
  // For each label, how far the text speaks for it: about 1 if it fits, -1 if
  // not. Features that no example had pull all scores towards -1.
  std::vector<float> scores;
  // The share of the text that examples had, 0 to 1, weighted by rarity.
  float known = 0;
};

// What a classifier looks at.
enum class Evidence : std::uint8_t {
  words,
  sentences, // what a text means as a whole, too, if it is told
};

// Immutable once trained; any number of threads may use it.
class Classifier {
public:
  Classifier() = default;

  // Trains on all texts. Labels are 0 to `labels` - 1. Returns nothing if that
  // would take more than `max_weights` weights of four bytes. Time: 8 rounds x
  // features of all texts x labels.
  static std::optional<Classifier> train(const std::vector<LabelledText>& texts,
                                         std::uint32_t labels,
                                         std::size_t max_weights = no_limit,
                                         Evidence evidence = Evidence::words);

  TextReading read(const TextFeatures& features) const;

private:
  friend class ClassifierTraining;

  struct Input {
    FeatureNumber feature = 0;
    float value = 0;
  };

  void number_features(const std::vector<LabelledText>& texts,
                       Evidence evidence);
  std::vector<Input> features(const TextFeatures& text) const;
  void add_meanings(const TextFeatures& text, std::vector<Input>& made) const;
  // Adds to `scores`, which has `stride_` entries.
  void add_scores(const std::vector<Input>& inputs, float* scores) const;
  std::size_t rows() const {
    return table_.size() + meanings_ + sentences_ + 1;
  }
  Input bias() const;
  float* row(std::size_t number) {
    return &weights_[number * stride_];
  }

  std::uint32_t labels_ = 0;
  // `labels_`, rounded up so that processors can work on several at once.
  std::size_t stride_ = 0;
  FeatureTable table_;
  // The weight of each feature by how few texts have it (inverse document
  // frequency); the last one is that of features which no text has.
  std::vector<float> rarity_;
  // The numbers of a meaning, and of a sentence; 0 if no text has one.
  std::size_t meanings_ = 0;
  std::size_t sentences_ = 0;
  // How much a sentence counts beside all its features.
  float weight_of_sentence_ = 0;
  // One row for each feature with a weight for each label, then one for each
  // number of the meaning and of the sentence; the last row is the bias.
  std::vector<float> weights_;
};

} // namespace parlour::adapters::nlu
