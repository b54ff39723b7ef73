// Acts that were learnt from examples, beside those that grammars found: where
// grammars found nothing, or only a value, or not all that was said.
#pragma once

#include <vector>

#include "adapters/nlu/parse/acts.hpp"
#include "adapters/nlu/understand/learned.hpp"

namespace parlour::adapters::nlu {

// Best first: the likeliest topic's act, then those of topics almost as likely.
// Those that do not reach the threshold are left out.
std::vector<BuiltAct> guessed_acts(const Learned& learned,
                                   const Utterance& utterance, Spans& spans,
                                   const Schema& schema, const Context& context,
                                   double threshold);

// Whether examples may know more than these acts of grammars.
bool leaves_open(const std::vector<BuiltAct>& acts);

// The guess in place of the acts where it is better; else what it found beside
// them. True if it took their place. A value alone goes on with what the
// context expects, whatever the examples say.
bool prefer_better(std::vector<BuiltAct>& acts, const BuiltAct& guess,
                   const Context& context);

} // namespace parlour::adapters::nlu
