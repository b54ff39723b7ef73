// Words of an utterance, of a grammar or of a value, all made the same way so
// that they can be compared. Tolerant: any bytes are taken, what is not valid
// UTF-8 separates words. Time is linear in the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::nlu {

// What more there is than this is not looked at; `Tokens::truncated` says so.
inline constexpr std::size_t max_tokens = 160;
inline constexpr std::size_t max_word_bytes = 64;

// What stands between a word and the one before it.
enum class Break : std::uint8_t { none, comma, sentence };

struct Token {
  std::uint32_t begin = 0; // bytes of the text
  std::uint32_t end = 0;
  std::string word; // lower case, accents and apostrophes gone
  Break before = Break::none;
};

struct Tokens {
  std::vector<Token> list;
  bool truncated = false;
};

// "I'm at Ho's, 10:30am" is: i am at ho 10:30am. Times, dates, telephone
// numbers and e-mail addresses stay one word.
Tokens tokenize(std::string_view text);

// The part of the text that tokens [first, last) stand for.
std::string_view words_of(std::string_view text, const Tokens& tokens,
                          std::size_t first, std::size_t last);

} // namespace parlour::adapters::nlu
