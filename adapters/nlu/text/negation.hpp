// Finds words that negate an order: "do not open the door", "never open it", "I
// don't want to". Such an order must not be carried out.
#pragma once

#include <string_view>
#include <vector>

#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu {

// For each token, whether it negates what follows. "not" does not negate in a
// question ("why not …", "is there not …", "can't I …") or in a report of the
// past.
std::vector<bool> negations(const Tokens& tokens);

// "not" or "never", whatever it does there.
bool is_not(std::string_view word);

// Whether the word may stand between a negation and what it negates: "want" and
// "to" in "(do not) want to open".
bool is_linking_word(std::string_view word);

// Whether the "not" at this token only warns: "don't spill it", "don't be
// late".
bool is_warning(const Tokens& tokens, std::size_t token);

// Whether the utterance as a whole is a negated order: "please do not …", "no
// taxi then".
// `negates` is the result of negations().
bool is_negated_order(const Tokens& tokens, const std::vector<bool>& negates);

// Whether it is wanted that something ends or does not happen: "cancel my
// table", "can we call it off". Not where that is only thought of or asked
// about: "what if I cancel it", "how do I cancel".
bool calls_off(const Tokens& tokens);

} // namespace parlour::adapters::nlu
