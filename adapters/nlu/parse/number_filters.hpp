// Filters that take out islands whose number means something else
// (docs/understanding.md, "Guesses and certain values").
#pragma once

#include <vector>

#include "adapters/nlu/parse/islands.hpp"

namespace parlour::adapters::nlu {

// Takes out what ends in a number of which the next word says what it counts:
// "room for two" in "a conference room for two hours". An answer may be said
// with its unit.
void leave_out_counts(std::vector<Island>& islands, const Utterance& utterance,
                      const Spans& spans);

// Takes out numbers that are too small for their slot, unless it is asked for
// or named: "thirty roses" is no booking of four digits (Schema::Slot::fewest).
void leave_out_small_numbers(std::vector<Island>& islands,
                             const Utterance& utterance, const Spans& spans,
                             const Schema& schema, const Context& context);

} // namespace parlour::adapters::nlu
