// Measures how similar two words are, to recognise misspellings and mistakes of
// a speech recogniser.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace parlour::adapters::nlu {

// 1 for equal words, 0 for words with nothing in common. It is 1 minus a
// weighted edit distance divided by the length of the longer word. Errors that
// are common in spelling cost less than 1: a doubled letter, one vowel for
// another, consonants that sound alike, a silent letter, two neighbours that
// change places.
//
// Only the first 32 bytes are compared, so the time is bounded. Words must be
// in lower case. Where it is less than `least`, it may be told as any number
// below that, which takes less time.
double similarity(std::string_view left, std::string_view right,
                  double least = 0);

// A bit for each of the letters a to z that a word has.
std::uint32_t letters_in(std::string_view word);

// The most that two words can be similar, the longer of which has this length,
// by their letters alone.
double similarity_at_most(std::uint32_t left, std::uint32_t right,
                          std::size_t length);

// The least similarity at which a word of this length counts as a misspelling.
// Short words must be more similar: in "bat" one wrong letter makes another
// word.
double similarity_needed(std::size_t length);

// ", did you mean 'x'?" with the most similar of `known`, or an empty text if
// none is similar. For the end of an error message.
std::string did_you_mean(std::string_view word,
                         std::span<const std::string> known);

} // namespace parlour::adapters::nlu
