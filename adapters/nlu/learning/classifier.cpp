#include "adapters/nlu/learning/classifier.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "adapters/nlu/learning/shuffle.hpp"

namespace parlour::adapters::nlu {

namespace {

// How often each text is seen at most.
constexpr int rounds = 8;
// What a text costs that is on the wrong side of a label, beside large weights.
constexpr float cost = 2;
// A step that is smaller changes nothing.
constexpr float small_step = 1e-4F;
// The input of the bias. It is small, so that the features explain what they
// can.
constexpr float bias_input = 0.1F;
// How much the kind of a value counts beside a word as frequent.
constexpr float weight_of_kind = 3;
// How much a text's meaning counts beside all its features.
constexpr float weight_of_meaning = 0.7F;
// The same for what it means as a whole, and among many texts, which have most
// words themselves.
constexpr float weight_of_sentence = 1.5F;
constexpr float weight_of_sentence_among_many = 0.6F;
// With so many texts, features that occur in only one of them are left out.
constexpr std::size_t many_texts = 2000;
// Labels that are worked on at once.
constexpr std::size_t lanes = 4;

} // namespace

// Dual coordinate descent: each text has a factor for each label by which it
// pulls the label's weights its way, at least 0. A step sets one factor so that
// the loss is smallest while all others stand. Most factors are and stay 0, so
// only the others are stored.
class ClassifierTraining {
public:
  ClassifierTraining(Classifier& made, const std::vector<LabelledText>& texts)
      : made_(made), texts_(texts), factors_(texts.size()),
        scores_(made.stride_) {
    for (const auto& text : texts) {
      features_.push_back(made.features(text.features));
      features_.back().push_back(made.bias());
    }
  }

  void run() {
    made_.weights_.assign(made_.rows() * made_.stride_, 0);
    ShuffledOrder order(texts_.size());
    for (int round = 0; round < rounds; ++round)
      for (const auto at : order.next())
        learn(at);
  }

private:
  struct Factor {
    std::uint32_t label = 0;
    float value = 0;
  };

  void learn(std::size_t at) {
    inputs_ = features_[at];
    made_.add_meanings(texts_[at].features, inputs_);
    std::ranges::fill(scores_, 0.0F);
    made_.add_scores(inputs_, scores_.data());
    float length = 0;
    for (const auto& input : inputs_)
      length += input.value * input.value;
    moves_.clear();
    factors_[at] = stepped(factors_[at], texts_[at].label, length);
    for (const auto& input : inputs_)
      for (auto* row = made_.row(input.feature); const auto& move : moves_)
        row[move.label] += move.value * input.value;
  }

  // The factors after a step for each label. Collects what the weights move by.
  std::vector<Factor> stepped(const std::vector<Factor>& before,
                              std::uint32_t label, float length) {
    constexpr float softness = 0.5F / cost;
    std::vector<Factor> after;
    auto next = before.begin();
    for (std::uint32_t one = 0; one < made_.labels_; ++one) {
      const float side = one == label ? 1.0F : -1.0F;
      const bool has = next != before.end() && next->label == one;
      const auto value = has ? (next++)->value : 0.0F;
      const auto slope = side * scores_[one] - 1 + softness * value;
      if (!has && slope >= 0)
        continue;
      const auto better = std::max(0.0F, value - slope / (length + softness));
      const bool moves = std::abs(better - value) > small_step;
      if (moves)
        moves_.push_back({one, side * (better - value)});
      if (const auto kept = moves ? better : value; kept > 0)
        after.push_back({one, kept});
    }
    return after;
  }

  Classifier& made_;
  const std::vector<LabelledText>& texts_;
  // By text; without the numbers of meanings, which are hundreds.
  std::vector<std::vector<Classifier::Input>> features_;
  std::vector<Classifier::Input> inputs_; // of one text
  // By text; sorted by label.
  std::vector<std::vector<Factor>> factors_;
  std::vector<float> scores_;
  std::vector<Factor> moves_;
};

std::optional<Classifier>
Classifier::train(const std::vector<LabelledText>& texts, std::uint32_t labels,
                  std::size_t max_weights, Evidence evidence) {
  Classifier made;
  made.labels_ = labels;
  made.stride_ = (labels + lanes - 1) / lanes * lanes;
  made.number_features(texts, evidence);
  if (made.rows() * made.stride_ > max_weights)
    return {};
  ClassifierTraining(made, texts).run();
  return made;
}

// Numbers the features that occur often enough and computes their rarity: 1 +
// log(texts + 1) - log(count + 1).
void Classifier::number_features(const std::vector<LabelledText>& texts,
                                 Evidence evidence) {
  const bool are_many = texts.size() >= many_texts;
  const std::uint32_t needed = are_many ? 2 : 1;
  weight_of_sentence_ =
      are_many ? weight_of_sentence_among_many : weight_of_sentence;
  std::unordered_map<Feature, std::uint32_t> counts;
  for (const auto& text : texts) {
    for (const auto feature : text.features.features)
      if (++counts[feature] == needed)
        table_.add(feature);
    meanings_ = std::max(meanings_, text.features.meaning.size());
    if (evidence == Evidence::sentences)
      sentences_ = std::max(sentences_, text.features.sentence.size());
  }
  const auto all = static_cast<float>(texts.size() + 1);
  rarity_.assign(table_.size() + 1, 1 + std::log(all));
  for (const auto& [feature, count] : counts)
    if (const auto number = table_.find(feature); number != no_feature)
      rarity_[number] -= std::log(static_cast<float>(count + 1));
}

// The features as a vector of length 1, weighted by rarity. Unknown features
// count for the length but have no entry, so that a text full of them scores
// low everywhere.
std::vector<Classifier::Input>
Classifier::features(const TextFeatures& text) const {
  std::vector<Input> made;
  float sum = 0;
  for (const auto feature : text.features) {
    const auto number = table_.find(feature);
    const auto kind = class_of(feature);
    if (number == no_feature && kind == FeatureClass::word_of_value)
      continue;
    auto value = number == no_feature ? rarity_.back() : rarity_[number];
    if (kind == FeatureClass::kind_of_value)
      value *= weight_of_kind;
    sum += value * value;
    if (number != no_feature)
      made.push_back({number, value});
  }
  for (auto& input : made)
    input.value /= std::sqrt(sum);
  return made;
}

// The meanings are vectors beside the features.
void Classifier::add_meanings(const TextFeatures& text,
                              std::vector<Input>& made) const {
  const auto add = [&](const std::vector<float>& numbers, std::size_t first,
                       std::size_t most, float weight) {
    for (std::size_t at = 0; at < std::min(most, numbers.size()); ++at)
      made.push_back(
          {static_cast<FeatureNumber>(first + at), weight * numbers[at]});
  };
  add(text.meaning, table_.size(), meanings_, weight_of_meaning);
  add(text.sentence, table_.size() + meanings_, sentences_,
      weight_of_sentence_);
}

Classifier::Input Classifier::bias() const {
  return {static_cast<FeatureNumber>(rows() - 1), bias_input};
}

void Classifier::add_scores(const std::vector<Input>& inputs,
                            float* scores) const {
  for (const auto& input : inputs) {
    const auto* row = &weights_[input.feature * stride_];
    for (std::size_t first = 0; first < stride_; first += lanes) {
      std::array<float, lanes> products;
      for (std::size_t lane = 0; lane < lanes; ++lane)
        products[lane] = row[first + lane] * input.value;
      for (std::size_t lane = 0; lane < lanes; ++lane)
        scores[first + lane] += products[lane];
    }
  }
}

TextReading Classifier::read(const TextFeatures& features) const {
  TextReading made;
  auto all = this->features(features);
  for (const auto& input : all)
    made.known += input.value * input.value;
  add_meanings(features, all);
  all.push_back(bias());
  made.scores.resize(stride_);
  add_scores(all, made.scores.data());
  made.scores.resize(labels_);
  return made;
}

} // namespace parlour::adapters::nlu
