// UTF-8 for the tokenizer: reads one character at a time and folds it, so that
// words can be compared without regard to capitals and accents.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace parlour::adapters::nlu {

struct Character {
  char32_t code = 0;
  // Its bytes; 1 if they are not valid UTF-8.
  std::uint32_t length = 1;
};

// The character at byte `position`, which must be inside of `text`. Bytes that
// are not valid give U+FFFD.
Character character_at(std::string_view text, std::size_t position);

// Letters, digits and combining accents.
bool is_word_character(char32_t code);
bool is_upper(char32_t code);

// Appends the character in lower case and without its accent: "É" gives "e".
void append_folded(std::string& word, char32_t code);

} // namespace parlour::adapters::nlu
