// How much of its words an act explains, and whether it is expected
// (understanding, "Score").
#pragma once

#include <vector>

#include "adapters/nlu/acts/chain.hpp"
#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// Sets `understood` and `score` of acts that were made of this chain.
void set_scores(std::vector<BuiltAct>& acts, const Chain& chain,
                const Utterance& utterance, const Context& context);

} // namespace parlour::adapters::nlu
