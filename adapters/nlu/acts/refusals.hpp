// Denials that refuse nothing: "don't spill it" beside an answer, and a refusal
// of what nobody offers. Pure.
#pragma once

#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/parse/context.hpp"

namespace parlour::adapters::nlu {

// Whether the act, a "deny" about no topic, is one, beside the other acts of
// the utterance. Where a question waits for an answer, none is.
bool refuses_nothing(const BuiltAct& act, const std::vector<BuiltAct>& acts,
                     const Utterance& utterance, const Context& context);

} // namespace parlour::adapters::nlu
