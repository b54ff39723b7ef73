// What is only politeness if something else is said: "Good morning, …", "Okay,
// …", "…, thank you". With it or without, a sentence means the same. Pure.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "adapters/nlu/acts/chain.hpp"
#include "adapters/nlu/grammar/utterance.hpp"

namespace parlour::adapters::nlu {

// Whether a generic act is one.
bool is_courtesy(std::string_view act);

// Whether a generic act that begins at this token only opens or closes what is
// said: a greeting, thanks, and an "okay" at the beginning of a sentence where
// nothing is asked.
bool is_opening(std::string_view act, std::uint32_t begin,
                const Utterance& utterance, const Context& context);

// By token: whether it belongs to either.
std::vector<bool> courtesy_tokens(const Chain& chain,
                                  const Utterance& utterance,
                                  const Context& context);

// The same utterance, with such tokens as fillers.
Utterance without_courtesies(Utterance utterance, const Chain& chain,
                             const Context& context);

} // namespace parlour::adapters::nlu
