// The features that classifier and tagger see of words. A feature is a 64-bit
// hash, so no names are stored; a table numbers those that occurred in
// training.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "adapters/nlu/learning/word_vectors.hpp"

namespace parlour::adapters::nlu {

using Feature = std::uint64_t;
// The lowest bits tell what a feature of a text counts for.
enum class FeatureClass : std::uint8_t {
  plain,
  // A word of a known value: counts if an example had it, too.
  word_of_value,
  // The kind of a known value: counts more than a word.
  kind_of_value,
};
inline constexpr Feature class_bits = 3;
constexpr FeatureClass class_of(Feature feature) {
  return static_cast<FeatureClass>(feature & class_bits);
}
using FeatureNumber = std::uint32_t;
inline constexpr FeatureNumber no_feature = 0xFFFFFFFF;
// Of the number of weights in training.
inline constexpr std::size_t no_limit = static_cast<std::size_t>(-1);

// Numbers features in the order in which they are added.
class FeatureTable {
public:
  FeatureNumber add(Feature feature) {
    const auto next = static_cast<FeatureNumber>(numbers_.size());
    return numbers_.try_emplace(feature, next).first->second;
  }
  // no_feature if it was not added.
  FeatureNumber find(Feature feature) const {
    const auto found = numbers_.find(feature);
    return found == numbers_.end() ? no_feature : found->second;
  }
  std::size_t size() const {
    return numbers_.size();
  }

private:
  std::unordered_map<Feature, FeatureNumber> numbers_;
};

// A word as the learning sees it.
struct LearningWord {
  // Not owned.
  std::string_view word;
  // What the word is known to be part of (a normal form, a set of values); 0:
  // nothing.
  std::uint32_t kind = 0;
  WordMeaning meaning = {};
  // Means nothing ("er", "please"), and has no part in what a sentence means.
  bool filler = false;
};

struct TextFeatures {
  // Each once, sorted.
  std::vector<Feature> features;
  // What its words mean together, as a vector of length 1; empty if no word has
  // a meaning.
  std::vector<float> meaning;
  // What it means as a whole, as another vector of length 1; empty if nobody
  // has said.
  std::vector<float> sentence = {};

  bool operator==(const TextFeatures&) const = default;
};

// The features of a text: its words, pairs of adjacent words, and pieces of
// words of three and four letters, all without fillers. In pairs, words of a
// value are replaced by its kind, so that one name in the examples stands for
// all; such words have no part in the meaning.
TextFeatures text_features(const std::vector<LearningWord>& words);

// The features of each word: the word, its neighbours, how it begins and ends,
// kinds, groups of meaning.
std::vector<std::vector<Feature>>
word_features(const std::vector<LearningWord>& words);

} // namespace parlour::adapters::nlu
