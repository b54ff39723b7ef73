// NearestTexts remembers texts and finds those that another one is like: by
// words, pairs of words and beginnings of words, of which rare ones count more
// (the cosine of their weights by inverse document frequency).
//
//  NearestTexts texts;
//  texts.add({"where", "is", "the", "@3"}, 7);
//  texts.finish();
//  texts.find({{"where", "might", "@3", "be"}}, 1); // label 7, 0.6 alike
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "adapters/nlu/learning/features.hpp"

namespace parlour::adapters::nlu {

struct NearText {
  std::uint32_t label = 0;
  std::uint32_t text = 0; // its number, in the order of add()
  float similarity = 0;   // 0 to 1
};

// How alike the few nearest texts are on average.
struct Nearness {
  float labelled = 0;
  float other = 0; // of those without a label
};

// Once finished, any number of threads may use it.
class NearestTexts {
public:
  using Words = std::vector<std::string>;

  void add(const Words& words, std::uint32_t label);
  // A text that speaks against all labels. find() does not see it, and it
  // makes no word less rare.
  void add_other(const Words& words);
  // Call it once, behind all texts.
  void finish();

  // The nearest text of each label, the most similar first, at most `most`.
  // `others` are, for some words, further ones as which they may be read.
  std::vector<NearText> find(const Words& words,
                             const std::vector<Words>& others,
                             std::size_t most) const;

  Nearness nearness(const Words& words, const std::vector<Words>& others) const;

  bool empty() const {
    return labels_.empty();
  }

private:
  struct Weighted {
    Feature feature = 0;
    float weight = 0;
  };
  struct Posting {
    std::uint32_t text = 0;
    float weight = 0;
  };
  using Postings = std::vector<Posting>;
  // The texts that have a feature: those with a label, and those without.
  struct Column {
    float rarity = 0;
    Postings labelled;
    Postings other;
  };
  // For each text, its product with some words, which have this length.
  struct Products {
    std::vector<float> labelled;
    std::vector<float> other; // empty if they are not wanted
    float length = 0;
  };

  static std::vector<Weighted> features(const Words& words);
  static std::vector<Feature> values(const Words& words);
  void post(std::vector<std::vector<Weighted>>& waiting,
            Postings Column::*postings);
  Products products(const Words& words, const std::vector<Words>& others,
                    bool with_other_texts) const;

  // Until finish().
  std::vector<std::vector<Weighted>> waiting_;
  std::vector<std::vector<Weighted>> waiting_others_;
  std::uint32_t other_count_ = 0;
  std::vector<std::uint32_t> labels_;        // by text
  std::vector<std::vector<Feature>> values_; // by text, sorted
  std::uint32_t label_count_ = 0;
  std::unordered_map<Feature, Column> columns_;
};

} // namespace parlour::adapters::nlu
