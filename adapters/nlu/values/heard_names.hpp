// Names of people as a recogniser writes them that does not know them: "Rajesh
// Seng of Chandran" for Rajesh s/o Chandran, "Kekzu Qing" for Quek Xue Qing.
// Word by word they are somebody else's; said as a whole they sound alike.
#pragma once

#include <vector>

#include "adapters/nlu/values/value_index.hpp"

namespace parlour::adapters::nlu {

// What such a name is worth, so that the dialogue asks back (engine rule 5.5).
inline constexpr float heard_confidence = 0.6F;

// Runs of words that sound like whole names of people of the set, one name or
// the few that sound most like them, without overlaps. Only for what was heard:
// written words mean what they say. At least half of a run are no `plain`
// words (see ValueIndex::find), and none is a number. Each word of a name must
// sound like what was heard in its place; words may be divided otherwise
// ("Vijson of Chandran" for Vijay s/o Chandran) where not each of them is one
// of names. Behind the first word of a name as it is written, words that no
// name has need only sound a little alike ("Lorraine Gove" for Lorraine Goh).
// The time is bounded.
std::vector<ValueMatch> heard_names(const ValueIndex& index, SetId set,
                                    const Tokens& tokens,
                                    const std::vector<bool>& plain);

// Who may have been said as well as the one of the match, whose name is whole:
// people whose names sound the same (Alan and Allan Teo).
void add_names_of_the_same_sound(const ValueIndex& index, ValueMatch& match);

} // namespace parlour::adapters::nlu
