// Values that are only mentioned beside an answer.
#pragma once

#include <vector>

#include "adapters/nlu/parse/islands.hpp"

namespace parlour::adapters::nlu {

// "The blue. I broke the handle of the red one": takes out values without an
// act that a statement of words that no rule knows mentions, where another
// sentence is nothing but a value of the same slot.
void leave_out_mentions(std::vector<Island>& islands,
                        const Utterance& utterance);

} // namespace parlour::adapters::nlu
