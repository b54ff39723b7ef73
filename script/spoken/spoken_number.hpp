// Numbers in English words (language rule 8.12).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/text/decimal.hpp"

namespace parlour::script {

// "minus two point five", "one thousand and five". Numbers of more than fifteen
// digits or below a millionth are given as they are printed.
std::string cardinal_words(const Decimal& number);
std::string cardinal_words(std::int64_t number);

// "twenty third".
std::string ordinal_words(std::int64_t number);

// "nineteen thirty eight", "two thousand and five".
std::string year_words(std::int64_t year);

// Digit by digit in groups of four from the right: "one two, three four five
// six". A text with letters is returned unchanged.
std::string digit_words(std::string_view text);

// The number and what it counts: "two boxes". If `several` is empty, the
// regular plural of the noun is used.
std::string counted(const Decimal& number, const std::string& noun,
                    const std::string& several = {});

// "A, B and C", with `link` as the last word between them.
std::string series(const std::vector<std::string>& parts,
                   std::string_view link);

} // namespace parlour::script
