// Which values of an island are denied, above all where one slot takes several:
// "no towels please, one more pillow".
#pragma once

#include <cstdint>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/islands.hpp"

namespace parlour::adapters::nlu {

// Whether the marker is a "not" at the end of a sentence, and denies nothing
// behind it: "She isn't. Toilets?"
bool ends_sentence(const Utterance& utterance, const Island& marker);

// Whether the marker is a "no" that begins a clause, and the island's first
// value follows it at once: "no towels". "No, towels" and "there are no towels"
// want some.
bool denies_first_value(const Utterance& utterance, const Island& marker,
                        const Island& island);

// The token behind the denied values of the island, of which the first one is
// denied: where "only", "but" or "just" begins what is wanted, or words other
// than a value follow a comma. Its end, if there is none.
std::uint32_t end_of_denied(const Utterance& utterance, const Island& island);

} // namespace parlour::adapters::nlu
