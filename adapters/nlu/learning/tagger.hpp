// Finds slots' words by an averaged structured perceptron, trained in memory
// with the same result every time: each word is outside of all slots, or
// begins or goes on with one. Immutable once trained; any number of threads
// may ask it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "adapters/nlu/learning/features.hpp"

namespace parlour::adapters::nlu {

// 0: of no slot; 2 * slot + 1: begins the slot; 2 * slot + 2: goes on with it.
using TagLabel = std::uint32_t;
inline constexpr TagLabel outside = 0;
constexpr TagLabel begins(std::uint32_t slot) {
  return 2 * slot + 1;
}
constexpr TagLabel goes_on(std::uint32_t slot) {
  return 2 * slot + 2;
}
constexpr std::uint32_t slot_of(TagLabel label) {
  return (label - 1) / 2;
}
constexpr bool is_beginning(TagLabel label) {
  return label % 2 == 1;
}

struct TaggedText {
  std::vector<std::vector<Feature>> features; // word_features
  std::vector<TagLabel> labels;               // for each word
  std::vector<std::uint32_t> slots;           // that may be in it
};

class Tagger {
public:
  Tagger() = default;

  // Slots are 0 to slots - 1. Nothing where that would take more than so many
  // weights, of four bytes each, and twice as many in training.
  static std::optional<Tagger> train(const std::vector<TaggedText>& texts,
                                     std::uint32_t slots,
                                     std::size_t most_weights = no_limit);

  // The likeliest labels, of these slots only, one for each word.
  std::vector<TagLabel> tag(const std::vector<std::vector<Feature>>& features,
                            const std::vector<std::uint32_t>& slots) const;

private:
  friend class TaggerTraining;
  friend class LabelSearch;

  using Rows = std::vector<std::vector<FeatureNumber>>;

  Rows rows(const std::vector<std::vector<Feature>>& features) const;
  const float* row(std::size_t number) const {
    return &weights_[number * labels_];
  }
  // The row of what may follow a label.
  std::size_t after(TagLabel label) const {
    return table_.size() + label;
  }

  std::uint32_t labels_ = 1;
  FeatureTable table_;
  std::vector<float> weights_{0}; // a row of labels for each feature, and label
};

} // namespace parlour::adapters::nlu
