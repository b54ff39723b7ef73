// Filters that look at the clause in which an act stands.
#pragma once

#include <vector>

#include "adapters/nlu/parse/islands.hpp"

namespace parlour::adapters::nlu {

// Takes out generic acts of which a clause has only the words: "stop" in "where
// do the taxis stop", and "it is", "you can" or "do it", which are a yes by
// themselves, in "it is the eye clinic". The words of a question that waits for
// a yes may follow: "it is the blue one".
void leave_out_half_clauses(std::vector<Island>& islands,
                            const Utterance& utterance, const Context& context);

// Takes out orders in questions about what has happened: in "did I leave my
// laptop in the hall?" nothing is to be left there.
void leave_out_past_orders(std::vector<Island>& islands,
                           const Utterance& utterance, const Schema& schema);

} // namespace parlour::adapters::nlu
