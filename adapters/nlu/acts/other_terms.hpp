// "Yes, in an hour", "yes, if it is free", "yes, but the other room": what
// stands beside a yes and makes it one to something else than is about to be
// done.
#pragma once

#include <optional>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// The words, where a yes or no is waited for: right behind the yes, in its
// sentence, a time that the question does not name, a condition or another
// choice. Not what an act gives the topic that goes on, or what a sentence
// about something else says. `yes` is one of the acts.
std::optional<TokenRange> other_terms(const Utterance& utterance,
                                      const std::vector<BuiltAct>& acts,
                                      const BuiltAct& yes,
                                      const Context& context);

} // namespace parlour::adapters::nlu
