// Tagger finds the words that fill slots. It labels each word as outside of all
// slots, as the beginning of a slot, or as its continuation (the IOB scheme).
// It is an averaged structured perceptron, trained in memory with the same
// result every time.
//
//  I        am       David           Tan               from     Comptec
//  outside  outside  begins Visitor  goes on, Visitor  outside  begins Firm
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "adapters/nlu/learning/features.hpp"

namespace parlour::adapters::nlu {

// 0: outside; 2 * slot + 1: begins the slot; 2 * slot + 2: continues it.
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
  // Made by word_features().
  std::vector<std::vector<Feature>> features;
  // One for each word.
  std::vector<TagLabel> labels;
  // The slots that the text may have.
  std::vector<std::uint32_t> slots;
};

// Immutable once trained; any number of threads may use it.
class Tagger {
public:
  Tagger() = default;

  // Trains on all texts. Slots are 0 to `slots` - 1. Returns nothing if that
  // would take more than `max_weights` weights of four bytes; training needs
  // twice the memory.
  static std::optional<Tagger> train(const std::vector<TaggedText>& texts,
                                     std::uint32_t slots,
                                     std::size_t max_weights = no_limit);

  // The most likely labels, one for each word, of these slots only. Time: words
  // x labels x (features of a word + labels that a label was seen after).
  std::vector<TagLabel> tag(const std::vector<std::vector<Feature>>& features,
                            const std::vector<std::uint32_t>& slots) const;

private:
  friend class TaggerTraining;
  friend class LabelSearch;

  using Rows = std::vector<std::vector<FeatureNumber>>;

  Rows rows(const std::vector<std::vector<Feature>>& features) const;
  void see_orders(const std::vector<TaggedText>& texts);
  const float* row(std::size_t number) const {
    return &weights_[number * stride_];
  }
  // The row with the weights of the labels that may follow `label`.
  std::size_t after(TagLabel label) const {
    return table_.size() + label;
  }

  std::uint32_t labels_ = 1;
  // `labels_`, rounded up so that processors can work on several at once.
  std::size_t stride_ = 4;
  FeatureTable table_;
  // One row for each feature, then one for each previous label, with a weight
  // for each label.
  std::vector<float> weights_ = std::vector<float>(4);
  // By label: those that stood before it in some text, and those that always
  // may: `outside`, and for a continuation its beginning and itself. Sorted.
  std::vector<std::vector<TagLabel>> before_{{outside}};
};

} // namespace parlour::adapters::nlu
