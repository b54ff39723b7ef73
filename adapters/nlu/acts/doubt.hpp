// Decides whether a yes is one. What follows a yes may not be reversible. So a
// yes beside a no, beside words such as "but" and "if", or beside words that
// were not understood counts as not said, and the question is asked again
// (understanding, "Yes and no").
#pragma once

#include <vector>

#include "adapters/nlu/acts/chain.hpp"
#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// Removes answers that are in doubt, and acts that are negated ("do not cancel
// it").
void drop_doubtful(std::vector<BuiltAct>& acts, const Chain& chain,
                   const Utterance& utterance, const Context& context);

} // namespace parlour::adapters::nlu
