// Names of people as a recogniser writes them that does not know them: "Rajesh
// Seng of Chandran" for Rajesh s/o Chandran, "Kekzu Qing" for Quek Xue Qing.
// Word by word they are somebody else's; said as a whole they sound alike.
#pragma once

#include <cstdint>
#include <vector>

#include "adapters/nlu/values/value_index.hpp"

namespace parlour::adapters::nlu {

// What such a name is worth, so that the dialogue asks back (engine rule 5.5).
inline constexpr float heard_confidence = 0.6F;

// Runs of words that sound like whole names of people, one name or the few that
// sound most like them, without overlaps within a set. Only for what was
// heard: written words mean what they say. Takes time with the number of words
// times that of names.
std::vector<ValueMatch> heard_names(const ValueIndex& index,
                                    const Tokens& tokens);

// This name of the set, and all that are said like it, if it has people.
std::vector<std::uint32_t> homophones(const ValueIndex& index, SetId set,
                                      std::uint32_t name);

} // namespace parlour::adapters::nlu
