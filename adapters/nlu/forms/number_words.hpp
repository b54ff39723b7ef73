// Reads whole numbers as people say and write them: "twenty three", "23rd",
// "1,000", "two hundred and five", "second".
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu {

struct NumberAt {
  std::int64_t value = 0;
  // In tokens.
  std::size_t length = 0;
  bool ordinal = false;
  // Written in digits.
  bool digits = false;
};

// Whether the word alone is a number, cardinal or ordinal.
bool is_number_word(std::string_view word);

// The longest whole number that begins at this token.
std::optional<NumberAt> number_at(const Tokens& tokens, std::size_t position);

// Reads "a couple of", "a pair of", "half a dozen", "two dozen".
std::optional<NumberAt> collective_at(const Tokens& tokens,
                                      std::size_t position);

// The digit of "nine", "9", "oh" …
std::optional<int> digit_of(std::string_view word);

// The number of a word that has digits only, 15 at most.
std::optional<std::int64_t> digits_of(std::string_view word);

} // namespace parlour::adapters::nlu
