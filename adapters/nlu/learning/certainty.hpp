// Certainty turns what the classifier says of a text into probabilities, with
// one more for a text about nothing that was learnt.
#pragma once

#include <cstdint>
#include <vector>

#include "adapters/nlu/learning/classifier.hpp"

namespace parlour::adapters::nlu {

// A text that was not learnt, with its label.
struct HeldOutText {
  TextReading reading;
  std::uint32_t label = 0;
};

class Certainty {
public:
  // For few examples, of which none can be held out.
  Certainty() = default;

  // For many texts beside many that are about nothing, where holding some out
  // would take as long as learning does.
  static Certainty of_many(Evidence evidence);

  // Such that of the texts which are told right, 39 of 40 reach `threshold`.
  Certainty(const std::vector<HeldOutText>& texts, double threshold);

  // One for each label. What is missing to 1 is the probability that the text
  // is about something else.
  std::vector<float> probabilities(const TextReading& reading) const;

private:
  // As the scores tell them, before the odds are better.
  std::vector<float> plain(const TextReading& reading) const;
  // The plain probabilities of the texts that are told right, sorted.
  std::vector<float> told_right(const std::vector<HeldOutText>& texts) const;

  // By how much the odds of a label ("three to one") are better than its score
  // says. The more labels and examples there are, the lower are the scores of
  // texts that were not learnt.
  float odds_ = 2;
  // How much words that no example has count against all labels. With few
  // examples, most words of other people are such.
  float weight_of_known_ = 0.3F;
};

} // namespace parlour::adapters::nlu
