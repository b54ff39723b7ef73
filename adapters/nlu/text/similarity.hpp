// How alike two words are, for misspellings and a recogniser's slips.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace parlour::adapters::nlu {

// 1 for equal words, 0 for nothing in common: a weighted edit distance in
// which a doubled letter, a vowel for a vowel, a silent letter and neighbours
// that change places cost less than one. Bytes of long words beyond 32 are not
// looked at.
double similarity(std::string_view left, std::string_view right);

// Below this two words are not the same word misspelt; short words must be
// closer.
double similarity_needed(std::size_t length);

// ", did you mean 'x'?" for the most similar of `known`, or nothing.
std::string did_you_mean(std::string_view word,
                         std::span<const std::string> known);

} // namespace parlour::adapters::nlu
