// Negation: words that turn an order round: "do not open the door", "never open
// it", "I don't want to". What such an order is about is not to be done.
#pragma once

#include <string_view>
#include <vector>

#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu {

// Whether each token does so. It does not in what is asked ("why not …", "is
// there not …", "can't I …") or told of the past.
std::vector<bool> negations(const Tokens& tokens);

// May stand between such a word and what it turns round: "(do not) want to".
bool is_linking_word(std::string_view word);

// Whether all that is said is such an order: "please do not …".
bool is_negated_order(const Tokens& tokens, const std::vector<bool>& negates);

} // namespace parlour::adapters::nlu
