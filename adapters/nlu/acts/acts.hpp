// Turns a chain of islands into acts (engine rule 5, "Acts"): islands of one
// topic become one act, corrections are applied, and acts that do not count are
// removed.
//
//  "a taxi to the airport, no, to the harbour"  inform Taxi {To: harbour}
//  "no, to the harbour"                         correct Taxi {To: harbour}
//  "hello, a taxi please"                       inform Taxi {}
#pragma once

#include <vector>

#include "adapters/nlu/acts/chain.hpp"
#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// Returns the acts in the order of the utterance. Acts with a score below
// `threshold` are left out.
std::vector<BuiltAct> build_acts(const Chain& chain, const Utterance& utterance,
                                 const Schema& schema, const Context& context,
                                 double threshold);

} // namespace parlour::adapters::nlu
