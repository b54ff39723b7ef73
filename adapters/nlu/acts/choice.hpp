// The answer to "Do you mean A or B?" in words that name neither: "the second
// one", "either", "with a K". Pure.
#pragma once

#include <optional>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// The act that fills the slot which was asked for with one of the context's
// choices, or refuses all of them. Nothing if the utterance says anything else,
// or if it leaves open which one is meant.
std::optional<BuiltAct> choice_of(const Utterance& utterance,
                                  const Context& context);

} // namespace parlour::adapters::nlu
