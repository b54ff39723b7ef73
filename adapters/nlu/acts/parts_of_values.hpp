// Parts of one value that are said apart: "It's Geetha, surname Nair", "the
// cup, please, the red one". Each alone fits several values, both together one.
#pragma once

#include <vector>

#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// Fills with several candidates keep those that the other parts fit, too, which
// must be no fill of their own and not be negated. Adds spans.
void join_parts_of_values(std::vector<BuiltAct>& acts,
                          const Utterance& utterance, Spans& spans);

} // namespace parlour::adapters::nlu
