// What a classifier and a tagger see of words: features, each a hash of 64
// bits, so that no names are kept; a table numbers those that training had.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace parlour::adapters::nlu {

using Feature = std::uint64_t;
using FeatureNumber = std::uint32_t;
inline constexpr FeatureNumber no_feature = 0xFFFFFFFF;
// Of weights that training may need.
inline constexpr std::size_t no_limit = static_cast<std::size_t>(-1);

// Numbers, in the order in which features came.
class FeatureTable {
public:
  FeatureNumber add(Feature feature) {
    const auto next = static_cast<FeatureNumber>(numbers_.size());
    return numbers_.try_emplace(feature, next).first->second;
  }
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

// A word as learning sees it; `kind` is what it is known to be part of (a
// normal form, a set of values), 0 for nothing.
struct LearningWord {
  std::string_view word; // not owned
  std::uint32_t kind = 0;
};

// Of a whole text: words, pairs of neighbours and pieces of words, each once,
// sorted. Of words of a kind only the kind counts, and once for all of them.
std::vector<Feature> text_features(const std::vector<LearningWord>& words);

// Of each word: itself, its neighbours, how it begins and ends, kinds.
std::vector<std::vector<Feature>>
word_features(const std::vector<LearningWord>& words);

} // namespace parlour::adapters::nlu
