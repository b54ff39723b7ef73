// The sentences of an utterance of which nothing was understood: "Yes, please.
// Could the children go for a swim at that hour?" What was learnt may know one
// that rules do not, but it only knows whole texts. Pure.
#pragma once

#include <string_view>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// Refers to the utterance's text, in its order; empty if it is one sentence, or
// if an act says what is wanted: what stands beside that tells why. Sentences
// of small words say nothing by themselves.
std::vector<std::string_view> left_sentences(const Utterance& utterance,
                                             const std::vector<BuiltAct>& acts);

} // namespace parlour::adapters::nlu
