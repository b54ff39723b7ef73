#include "script/dialogue/output/unheard_part.hpp"

#include <algorithm>
#include <cstddef>

namespace parlour::dialogue {

namespace {

// After so few words nobody knows yet what the answer is about (engine rule
// 3.7).
constexpr std::size_t too_few_words = 3;
constexpr std::string_view space = " \t\r\n";

// ASCII letters and digits, and all bytes of other characters in UTF-8, as
// without tables it is not known which of these are letters.
bool is_letter(char character) {
  const auto byte = static_cast<unsigned char>(character);
  return byte >= 0x80 || (byte >= '0' && byte <= '9') ||
         ((byte | 0x20) >= 'a' && (byte | 0x20) <= 'z');
}

char lower(char character) {
  return character >= 'A' && character <= 'Z'
             ? static_cast<char>(character | 0x20)
             : character;
}

// The next word, without what stands before it; empty at the end.
std::string_view next_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(space), rest.size()));
  const auto word = rest.substr(0, rest.find_first_of(space));
  rest.remove_prefix(word.size());
  return word;
}

// Long dashes, curled quotation marks, dots in threes: U+2000 to U+203F.
bool begins_with_mark(std::string_view rest) {
  return rest.size() >= 3 && rest.starts_with("\xE2\x80");
}

// Letters and digits, in small letters.
std::string plain(std::string_view word) {
  std::string letters;
  while (!word.empty()) {
    const bool is_mark = begins_with_mark(word);
    if (!is_mark && is_letter(word.front()))
      letters += lower(word.front());
    word.remove_prefix(is_mark ? 3 : 1);
  }
  return letters;
}

// The same where a dash or the like stands alone.
std::string next_plain_word(std::string_view& rest) {
  for (;;) {
    const auto word = next_word(rest);
    auto letters = plain(word);
    if (word.empty() || !letters.empty())
      return letters;
  }
}

} // namespace

// What a speaker reports as spoken has other marks and spaces than the text, so
// words are compared: of "It is on the left - behind the lift." and "it is on
// the" it returns "left - behind the lift.".
std::string unheard_part(std::string_view text, std::string_view heard) {
  auto rest = text;
  std::size_t words = 0;
  for (auto word = next_plain_word(heard); !word.empty();
       word = next_plain_word(heard), ++words)
    if (next_plain_word(rest) != word)
      return std::string(text);
  if (words < too_few_words)
    return std::string(text);
  rest.remove_prefix(std::min(rest.find_first_not_of(space), rest.size()));
  return plain(rest).empty() ? std::string() : std::string(rest);
}

} // namespace parlour::dialogue
