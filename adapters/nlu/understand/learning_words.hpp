// The words of an utterance as learning sees them (docs/understanding.md,
// "Examples").
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/learning/features.hpp"
#include "adapters/nlu/parse/spans.hpp"

namespace parlour::adapters::nlu {

// Those of a known value have its kind. `vectors` may be null. The words refer
// to the utterance and the vectors.
std::vector<LearningWord> learning_words(const Utterance& utterance,
                                         const Spans& spans,
                                         const WordVectors* vectors);

// Without fillers, for the encoder of sentences.
std::string text_of(const std::vector<LearningWord>& words);

} // namespace parlour::adapters::nlu
