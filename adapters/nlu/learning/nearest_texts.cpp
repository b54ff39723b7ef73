#include "adapters/nlu/learning/nearest_texts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "adapters/nlu/text/hash.hpp"

namespace parlour::adapters::nlu {

namespace {

// What a pair of words and the beginning of one count beside a word.
constexpr float weight_of_pair = 0.7F;
constexpr float weight_of_stem = 0.5F;
// Letters of a beginning; only of longer words.
constexpr std::size_t stem_letters = 4;
// Of the nearest texts: one may be alike by chance.
constexpr std::size_t few = 5;
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

void NearestTexts::add_other(const Words& words) {
  waiting_others_.push_back(features(words));
  ++other_count_;
}

// How rare a feature is, is told by the labels that have it: one label may have
// a hundred texts.
void NearestTexts::finish() {
  std::unordered_map<Feature, std::set<std::uint32_t>> labels_of;
  for (std::size_t text = 0; text < waiting_.size(); ++text)
    for (const auto& [feature, weight] : waiting_[text])
      labels_of[feature].insert(labels_[text]);
  const auto all = static_cast<float>(label_count_) + 1;
  for (const auto& text : waiting_others_)
    for (const auto& [feature, weight] : text)
      columns_[feature].rarity = std::log(all);
  for (const auto& [feature, labels] : labels_of)
    columns_[feature].rarity =
        std::log(all / (static_cast<float>(labels.size()) + 0.5F));
  post(waiting_, &Column::labelled);
  post(waiting_others_, &Column::other);
}

void NearestTexts::post(std::vector<std::vector<Weighted>>& waiting,
                        Postings Column::*postings) {
  for (std::uint32_t text = 0; text < waiting.size(); ++text) {
    float length = 0;
    for (auto& [feature, weight] : waiting[text]) {
      weight *= columns_[feature].rarity;
      length += weight * weight;
    }
    for (const auto& [feature, weight] : waiting[text])
      (columns_[feature].*postings)
          .push_back({text, weight / std::sqrt(length)});
  }
  waiting = {};
}

NearestTexts::Products NearestTexts::products(const Words& words,
                                              const std::vector<Words>& others,
                                              bool with_other_texts) const {
  const auto unknown = std::log(static_cast<float>(label_count_) + 1);
  Products made{std::vector<float>(labels_.size()),
                std::vector<float>(with_other_texts ? other_count_ : 0)};
  const auto look = [&](const Column& column, float weight) {
    for (const auto& posting : column.labelled)
      made.labelled[posting.text] += weight * posting.weight;
    if (with_other_texts)
      for (const auto& posting : column.other)
        made.other[posting.text] += weight * posting.weight;
  };
  float squares = 0;
  for (const auto& [feature, share] : features(words)) {
    const auto found = columns_.find(feature);
    const auto weight =
        share * (found == columns_.end() ? unknown : found->second.rarity);
    squares += weight * weight;
    if (found != columns_.end())
      look(found->second, weight);
  }
  for (const auto& further : others)
    for (const auto& other : further)
      if (const auto found = columns_.find(word_feature(other));
          found != columns_.end())
        look(found->second, weight_of_other * found->second.rarity);
  made.length = std::sqrt(squares);
  return made;
}

std::vector<NearText> NearestTexts::find(const Words& words,
                                         const std::vector<Words>& others,
                                         std::size_t most) const {
  const auto near_to = products(words, others, false);
  const auto& products = near_to.labelled;
  const auto length = near_to.length;
  const auto said = values(words);
  std::vector<NearText> best(label_count_);
  for (std::uint32_t text = 0; text < labels_.size(); ++text) {
    // Most texts share nothing with the words.
    if (products[text] == 0)
      continue;
    if (auto& near = best[labels_[text]];
        products[text] > near.similarity * length &&
        std::ranges::includes(said, values_[text]))
      near = {labels_[text], text, std::min(1.0F, products[text] / length)};
  }
  std::erase_if(best, [](const auto& near) { return near.similarity == 0; });
  std::ranges::stable_sort(best, std::greater(), &NearText::similarity);
  if (best.size() > most)
    best.resize(most);
  return best;
}

namespace {

// The largest of the values that were added, of few of them.
class Nearest {
public:
  // False: it would change nothing.
  bool takes(float value) const {
    return count_ < few || value > least_;
  }
  void add(float value) {
    *std::ranges::min_element(values_) = value;
    least_ = std::ranges::min(values_);
    ++count_;
  }
  float average() const {
    return std::accumulate(values_.begin(), values_.end(), 0.0F) /
           static_cast<float>(std::clamp(count_, std::size_t{1}, few));
  }

private:
  std::array<float, few> values_{};
  float least_ = 0;
  std::size_t count_ = 0;
};

} // namespace

Nearness NearestTexts::nearness(const Words& words,
                                const std::vector<Words>& others) const {
  const auto products = this->products(words, others, true);
  if (products.length == 0)
    return {};
  const auto said = values(words);
  Nearest labelled;
  for (std::size_t text = 0; text < labels_.size(); ++text)
    if (const auto product = products.labelled[text];
        labelled.takes(product) && std::ranges::includes(said, values_[text]))
      labelled.add(product);
  Nearest other;
  for (const auto product : products.other)
    if (other.takes(product))
      other.add(product);
  return {labelled.average() / products.length,
          other.average() / products.length};
}

} // namespace parlour::adapters::nlu
