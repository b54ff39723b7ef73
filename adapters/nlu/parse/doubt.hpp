// Decides whether a yes is one. What follows a yes may not be reversible. So a
// yes beside a no, beside words such as "but" and "if", or beside words that
// were not understood counts as not said, and the question is asked again
// (understanding, "Yes and no").
#pragma once

#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/parse/chain.hpp"

namespace parlour::adapters::nlu {

// While a question wants yes or no, "yes" and "no" are not values of slots.
// Otherwise they can be a value by themselves, of the slot that was asked for
// only. Removes the islands that say otherwise.
void prefer_answers(std::vector<Island>& islands, const Context& context);

// What an application means by words goes before what they mean anywhere:
// removes generic acts, other than yes and no, for the words of a rule of the
// application, and answers to what was asked that such a rule takes for another
// slot of the topic: "my name is …", where the host is asked for.
void prefer_application(std::vector<Island>& islands);

// Removes answers that are in doubt, and acts that are negated ("do not cancel
// it").
void drop_doubtful(std::vector<BuiltAct>& acts, const Chain& chain,
                   const Utterance& utterance, const Context& context);

} // namespace parlour::adapters::nlu
