#include "adapters/nlu/learning/nearest_texts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "adapters/nlu/text/hash.hpp"

namespace parlour::adapters::nlu {

namespace {

// What a pair of words and the beginning of one count beside a word.
constexpr float weight_of_pair = 0.7F;
constexpr float weight_of_stem = 0.5F;
// Letters of a beginning; only of longer words.
constexpr std::size_t stem_letters = 4;
// What another word for the same counts.
constexpr float weight_of_other = 0.8F;

Feature word_feature(std::string_view word) {
  return hash_of(word, hash_of("w"));
}

} // namespace

std::vector<NearestTexts::Weighted> NearestTexts::features(const Words& words) {
  std::vector<Weighted> made;
  std::string_view before = "^";
  for (const auto& word : words) {
    made.push_back({word_feature(word), 1});
    made.push_back({hash_of(word, hash_of(" ", hash_of(before, hash_of("b")))),
                    weight_of_pair});
    if (word.size() > stem_letters && !word.starts_with('@'))
      made.push_back({hash_of(std::string_view(word).substr(0, stem_letters),
                              hash_of("s")),
                      weight_of_stem});
    before = word;
  }
  std::ranges::sort(made, {}, &Weighted::feature);
  made.erase(std::unique(made.begin(), made.end(),
                         [](const auto& left, const auto& right) {
                           return left.feature == right.feature;
                         }),
             made.end());
  return made;
}

std::vector<Feature> NearestTexts::values(const Words& words) {
  std::vector<Feature> made;
  for (const auto& word : words)
    if (word.starts_with('@'))
      made.push_back(word_feature(word));
  std::ranges::sort(made);
  made.erase(std::unique(made.begin(), made.end()), made.end());
  return made;
}

void NearestTexts::add(const Words& words, std::uint32_t label) {
  waiting_.push_back(features(words));
  labels_.push_back(label);
  values_.push_back(values(words));
  label_count_ = std::max(label_count_, label + 1);
}

// How rare a feature is, is told by the labels that have it: one label may have
// a hundred texts.
void NearestTexts::finish() {
  std::unordered_map<Feature, std::set<std::uint32_t>> labels_of;
  for (std::size_t text = 0; text < waiting_.size(); ++text)
    for (const auto& [feature, weight] : waiting_[text])
      labels_of[feature].insert(labels_[text]);
  const auto all = static_cast<float>(label_count_) + 1;
  for (const auto& [feature, labels] : labels_of)
    columns_[feature].rarity =
        std::log(all / (static_cast<float>(labels.size()) + 0.5F));
  for (std::uint32_t text = 0; text < waiting_.size(); ++text) {
    float length = 0;
    for (auto& [feature, weight] : waiting_[text]) {
      weight *= columns_[feature].rarity;
      length += weight * weight;
    }
    for (const auto& [feature, weight] : waiting_[text])
      columns_[feature].texts.push_back({text, weight / std::sqrt(length)});
  }
  waiting_ = {};
}

std::vector<NearText> NearestTexts::find(const Words& words,
                                         const std::vector<Words>& others,
                                         std::size_t most) const {
  const auto unknown = std::log(static_cast<float>(label_count_) + 1);
  std::vector<float> products(labels_.size());
  float length = 0;
  const auto look = [&](const Column& column, float weight) {
    for (const auto& posting : column.texts)
      products[posting.text] += weight * posting.weight;
  };
  for (const auto& [feature, share] : features(words)) {
    const auto found = columns_.find(feature);
    const auto weight =
        share * (found == columns_.end() ? unknown : found->second.rarity);
    length += weight * weight;
    if (found != columns_.end())
      look(found->second, weight);
  }
  for (const auto& further : others)
    for (const auto& other : further)
      if (const auto found = columns_.find(word_feature(other));
          found != columns_.end())
        look(found->second, weight_of_other * found->second.rarity);
  const auto said = values(words);
  const auto root = std::sqrt(length);
  std::vector<NearText> best(label_count_);
  for (std::uint32_t text = 0; text < labels_.size(); ++text) {
    // Most texts share nothing with the words.
    if (products[text] == 0)
      continue;
    if (auto& near = best[labels_[text]];
        products[text] > near.similarity * root &&
        std::ranges::includes(said, values_[text]))
      near = {labels_[text], text, std::min(1.0F, products[text] / root)};
  }
  std::erase_if(best, [](const auto& near) { return near.similarity == 0; });
  std::ranges::stable_sort(best, std::greater(), &NearText::similarity);
  if (best.size() > most)
    best.resize(most);
  return best;
}

} // namespace parlour::adapters::nlu
