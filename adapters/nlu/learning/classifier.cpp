#include "adapters/nlu/learning/classifier.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/nlu/learning/shuffle.hpp"

namespace parlour::adapters::nlu {

namespace {

// How often each text is seen, and the learning rate in the first round. It
// falls linearly from round to round.
constexpr int rounds = 16;
constexpr float first_rate = 0.8F;
// A text whose squared error is below this changes nothing.
constexpr float small_error = 1e-4F;
// The input of the bias. It is small, so that the bias learns slowly and the
// features explain what they can.
constexpr float bias_input = 0.1F;
// With so many texts, features that occur in only one of them are left out.
constexpr std::size_t many_texts = 2000;

} // namespace

std::vector<float> softmax(std::vector<float> scores) {
  if (scores.empty())
    return scores;
  // Subtracting the maximum keeps exp() from overflowing.
  const auto most = *std::ranges::max_element(scores);
  float sum = 0;
  for (auto& score : scores)
    sum += score = std::exp(score - most);
  for (auto& score : scores)
    score /= sum;
  return scores;
}

std::optional<Classifier>
Classifier::train(const std::vector<LabelledText>& texts, std::uint32_t labels,
                  std::size_t max_weights) {
  Classifier made;
  made.labels_ = labels;
  made.number_features(texts);
  if ((made.table_.size() + 1) * labels > max_weights)
    return {};
  made.learn_all(texts);
  return made;
}

void Classifier::learn_all(const std::vector<LabelledText>& texts) {
  weights_.assign((table_.size() + 1) * labels_, 0);
  moved_.assign(table_.size() + 1, 0);
  std::vector<std::vector<Input>> inputs_of;
  for (const auto& text : texts)
    inputs_of.push_back(inputs(text.features));
  ShuffledOrder order(texts.size());
  for (int round = 0; round < rounds; ++round) {
    const auto rate = first_rate * static_cast<float>(rounds - round) / rounds;
    for (const auto at : order.next())
      learn(inputs_of[at], texts[at].label, rate);
  }
  moved_ = {};
}

// Numbers the features that occur often enough and computes their rarity: 1 +
// log(texts + 1) - log(count + 1).
void Classifier::number_features(const std::vector<LabelledText>& texts) {
  const std::uint32_t needed = texts.size() < many_texts ? 1 : 2;
  std::unordered_map<Feature, std::uint32_t> counts;
  for (const auto& text : texts)
    for (const auto feature : text.features)
      if (++counts[feature] == needed)
        table_.add(feature);
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
Classifier::inputs(const std::vector<Feature>& features) const {
  std::vector<Input> made;
  float sum = 0;
  for (const auto feature : features) {
    const auto number = table_.find(feature);
    const auto value = number == no_feature ? rarity_.back() : rarity_[number];
    sum += value * value;
    if (number != no_feature)
      made.push_back({number, value});
  }
  for (auto& input : made)
    input.value /= std::sqrt(sum);
  return made;
}

std::vector<float>
Classifier::scores_of(const std::vector<Input>& inputs) const {
  std::vector<float> made(weights_.end() - labels_, weights_.end());
  for (const auto& input : inputs) {
    const auto* row = &weights_[std::size_t(input.feature) * labels_];
    for (std::uint32_t label = 0; label < labels_; ++label)
      made[label] += row[label] * input.value;
  }
  return made;
}

std::vector<float>
Classifier::scores(const std::vector<Feature>& features) const {
  return scores_of(inputs(features));
}

float Classifier::known_share(const std::vector<Feature>& features) const {
  float share = 0;
  for (const auto& input : inputs(features))
    share += input.value * input.value;
  return share;
}

// One step of gradient descent with AdaGrad: each row has a learning rate of
// its own, the smaller the more the row has moved. `wrong` is the gradient with
// respect to the scores.
void Classifier::learn(const std::vector<Input>& inputs, std::uint32_t label,
                       float rate) {
  auto wrong = softmax(scores_of(inputs));
  wrong[label] -= 1;
  float size = 0;
  for (const auto one : wrong)
    size += one * one;
  if (size < small_error)
    return;
  const auto step = [&](std::size_t row, float value) {
    moved_[row] += size * value * value;
    move(row, rate * value / std::sqrt(moved_[row]), wrong);
  };
  for (const auto& input : inputs)
    step(input.feature, input.value);
  step(table_.size(), bias_input);
}

void Classifier::move(std::size_t row, float by,
                      const std::vector<float>& wrong) {
  auto* weights = &weights_[row * labels_];
  for (std::uint32_t label = 0; label < labels_; ++label)
    weights[label] -= by * wrong[label];
}

} // namespace parlour::adapters::nlu
