// Takes out values that are named beside something that is wanted, and say
// nothing of their own (understanding, "Guesses and certain values").
#pragma once

#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// The acts have their scores.
void drop_asides(std::vector<BuiltAct>& acts, const Utterance& utterance,
                 const Context& context);

} // namespace parlour::adapters::nlu
