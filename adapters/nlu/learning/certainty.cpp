#include "adapters/nlu/learning/certainty.hpp"

#include <algorithm>
#include <cmath>

namespace parlour::adapters::nlu {

namespace {

// How decided probabilities are: what the difference of two scores is worth.
constexpr float sharpness = 4;
// The score of being about nothing that was learnt.
constexpr float score_of_nothing = -0.4F;
// How much words that no example has count against all labels, where examples
// are many.
constexpr float weight_among_many = 0.6F;

// The share of the texts told right that may miss the threshold.
constexpr double may_miss = 0.025;
constexpr float least_odds = 1;
constexpr float most_odds = 40;
// What held-out texts gave for six applications with 1,800 to 3,100
// wordings: 4.7 to 8.2. With sentences beside words the scores are more
// decided, of what is about nothing, too.
constexpr float usual_odds = 6.5F;
constexpr float usual_odds_of_sentences = 5;

float strength(float score) {
  return std::exp(sharpness * score);
}

} // namespace

std::vector<float> Certainty::plain(const TextReading& reading) const {
  auto sum = strength(score_of_nothing);
  for (const auto score : reading.scores)
    sum += strength(score);
  const auto factor = std::pow(reading.known, weight_of_known_) / sum;
  std::vector<float> made;
  for (const auto score : reading.scores)
    made.push_back(strength(score) * factor);
  return made;
}

std::vector<float>
Certainty::told_right(const std::vector<HeldOutText>& texts) const {
  std::vector<float> made;
  for (const auto& text : texts) {
    const auto all = plain(text.reading);
    if (const auto most = std::ranges::max(all); all[text.label] == most)
      made.push_back(most);
  }
  std::ranges::sort(made);
  return made;
}

Certainty Certainty::of_many(Evidence evidence) {
  Certainty made;
  made.odds_ =
      evidence == Evidence::words ? usual_odds : usual_odds_of_sentences;
  made.weight_of_known_ = weight_among_many;
  return made;
}

Certainty::Certainty(const std::vector<HeldOutText>& texts, double threshold)
    : weight_of_known_(weight_among_many) {
  const auto right = told_right(texts);
  if (right.empty())
    return;
  const auto place =
      static_cast<std::size_t>(may_miss * static_cast<double>(right.size()));
  const auto lowest = std::clamp(right[place], 0.01F, 0.99F);
  const auto wanted = static_cast<float>(threshold / (1 - threshold));
  odds_ = std::clamp(wanted * (1 - lowest) / lowest, least_odds, most_odds);
}

std::vector<float> Certainty::probabilities(const TextReading& reading) const {
  auto made = plain(reading);
  const auto most = made.empty() ? 0 : std::ranges::max(made);
  // All are raised alike, so that they sum up to 1 at most.
  const auto factor = odds_ / (1 - most + odds_ * most);
  for (auto& one : made)
    one *= factor;
  return made;
}

} // namespace parlour::adapters::nlu
