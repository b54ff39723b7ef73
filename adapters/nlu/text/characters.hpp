// UTF-8 for the tokenizer: one character at a time, folded for comparison.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace parlour::adapters::nlu {

struct Character {
  char32_t code = 0;
  std::uint32_t length = 1; // bytes; 1 where they are not valid UTF-8
};

// The character at `position`, which is inside of `text`; U+FFFD where the
// bytes are not valid.
Character character_at(std::string_view text, std::size_t position);

bool is_word_character(char32_t code);
bool is_upper(char32_t code);

// Appends the character in lower case, without its accent.
void append_folded(std::string& word, char32_t code);

} // namespace parlour::adapters::nlu
