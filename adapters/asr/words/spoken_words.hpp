// Written text as the words that somebody says: "Dr. Ho, 10:30am" is "doctor ho
// ten thirty a.m.". Lower case; apostrophes stay ("i'm"). Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::asr {

std::vector<std::string> spoken_words(std::string_view text);

// A number in words, below a billion: {"twenty", "three"}.
std::vector<std::string> number_in_words(long long number);
// "first", "twenty third", of 1 to 99; others as a number.
std::vector<std::string> ordinal_in_words(long long number);

} // namespace parlour::adapters::asr
