// Numbers as English says them (language rule 8.12).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/decimal.hpp"

namespace parlour::script {

// "minus two point five", "one thousand and five"; from a quadrillion on, and
// below a millionth, as it is printed.
std::string cardinal_words(const Decimal& number);
std::string cardinal_words(std::int64_t number);

// "twenty third".
std::string ordinal_words(std::int64_t number);

// "nineteen thirty eight", "two thousand and five".
std::string year_words(std::int64_t year);

// Digit by digit, in groups of four: "one two, three four five six"; as it is
// where it has letters.
std::string digit_words(std::string_view text);

// "two boxes": the number and what it counts; `several` may be empty, then the
// regular plural is taken.
std::string counted(const Decimal& number, const std::string& noun,
                    const std::string& several = {});

// "A, B and C".
std::string series(const std::vector<std::string>& parts,
                   std::string_view link);

} // namespace parlour::script
