// How a word sounds, roughly: words of the same sound may be written for each
// other by a speech recogniser.
#pragma once

#include <string>
#include <string_view>

namespace parlour::adapters::nlu {

// Equal for "jeffery" and "geoffrey", "ho" and "hoh", "lim" and "ling": its
// consonants as they sound, of short words with their vowels. Empty if the word
// has other letters than a to z. The word must be in lower case.
std::string sound_of(std::string_view word);

} // namespace parlour::adapters::nlu
