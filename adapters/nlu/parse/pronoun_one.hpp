// "One" counts, or stands for what was spoken of. Pure.
#pragma once

#include <cstddef>

#include "adapters/nlu/grammar/utterance.hpp"

namespace parlour::adapters::nlu {

// Whether this word is "one" and no number: "one of those", "this one", "I've
// got one", "the little one"; but "room one".
bool is_pronoun_one(const Utterance& utterance, std::size_t position);

} // namespace parlour::adapters::nlu
