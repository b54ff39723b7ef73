// When a yes is one. What is done upon it may not be taken back, so that one
// said together with a no, with what turns it ("but", "if") or with words that
// nothing understood counts as not said, and is asked for again.
#pragma once

#include <vector>

#include "adapters/nlu/parse/acts.hpp"

namespace parlour::adapters::nlu {

// While a question of yes or no is asked, "yes" and "no" are no values; else
// they are, by themselves, of the slot that was asked for only.
void prefer_answers(std::vector<Island>& islands, const Context& context);

// Takes out answers in doubt, and wishes that are denied ("do not cancel it").
void drop_doubtful(std::vector<BuiltAct>& acts, const Chain& chain,
                   const Utterance& utterance, const Context& context);

} // namespace parlour::adapters::nlu
