// Parts of one value that are said apart: "It's Geetha, surname Nair", "the
// cup, please, the red one". Each alone fits several values, both together one.
#pragma once

#include <vector>

#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// Fills with several candidates keep those that the other parts fit, too. These
// stand in the same sentence or are all that another one says; they are no fill
// of their own, nor negated, nor merely alike. Adds spans.
void join_parts_of_values(std::vector<BuiltAct>& acts,
                          const Utterance& utterance, Spans& spans);

} // namespace parlour::adapters::nlu
