// The tokenizer. It splits utterances, grammars and values in the same way, so
// that their words can be compared. It accepts any bytes; bytes that are not
// valid UTF-8 separate words. Time is linear in the length of the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::nlu {

// The rest of a longer text is ignored, and `truncated` is set. The rest of a
// longer word is ignored, too.
inline constexpr std::size_t max_tokens = 160;
inline constexpr std::size_t max_word_bytes = 64;

// The punctuation between a word and the one before it, weakest first.
enum class Break : std::uint8_t { none, comma, sentence };

struct Token {
  // Bytes of the text.
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  // Lower case, without accents and apostrophes.
  std::string word;
  Break before = Break::none;
};

struct Tokens {
  std::vector<Token> list;
  bool truncated = false;
};

// "I'm at Ho's, 10:30am" gives i, am, at, ho, 10:30am. Contractions are
// expanded; times, dates, telephone numbers and e-mail addresses stay one word.
Tokens tokenize(std::string_view text);

// Tokens [begin, end).
struct TokenRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

// What stands around these tokens up to such punctuation, or stronger:
// Break::comma gives the clause, Break::sentence the sentence.
TokenRange stretch_of(const Tokens& tokens, TokenRange range, Break by);

// The part of the text that tokens [first, last) cover.
std::string_view words_of(std::string_view text, const Tokens& tokens,
                          std::size_t first, std::size_t last);

} // namespace parlour::adapters::nlu
