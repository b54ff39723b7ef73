#include "adapters/tts/spoken_text.hpp"

#include <algorithm>
#include <cstdint>

#include "runtime/base/text/utf8.hpp"
#include "runtime/text/words.hpp"

namespace parlour::adapters::tts {

namespace {

constexpr std::size_t longest_word = 80; // characters
// "Dr." and "p.m." end no sentence.
constexpr std::size_t longest_abbreviation = 3;
constexpr std::string_view closing = "\"')]}";

bool is_control(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return code < 0x20 || code == 0x7f;
}

// C1 controls (U+0080 to U+009F) are two bytes, the first of them 0xC2.
bool is_control_pair(std::string_view text, std::size_t at) {
  return at + 1 < text.size() && text[at] == '\xc2' &&
         static_cast<unsigned char>(text[at + 1]) < 0xa0;
}

std::string without_invalid(std::string_view text) {
  std::string valid(text);
  for (auto wrong = find_invalid_utf8(valid); wrong;
       wrong = find_invalid_utf8(valid))
    valid[*wrong] = ' ';
  return valid;
}

void blank_controls(std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (is_control(text[i]))
      text[i] = ' ';
    else if (is_control_pair(text, i))
      text[i] = text[i + 1] = ' ';
}

// The offset behind the first `count` characters.
std::size_t offset_after(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  for (; at < text.size(); ++at)
    if (!continues_code_point(text[at]) && count-- == 0)
      break;
  return at;
}

void add_in_parts(Words& words, std::string_view word) {
  while (!word.empty()) {
    const auto end = offset_after(word, longest_word);
    words.emplace_back(word.substr(0, end));
    word.remove_prefix(end);
  }
}

// The last character before quotes and brackets, or 0.
char last_sign(std::string_view& word) {
  const auto end = word.find_last_not_of(closing);
  if (end == std::string_view::npos)
    return 0;
  word = word.substr(0, end + 1);
  return word.back();
}

bool ends_sentence(std::string_view word) {
  const auto sign = last_sign(word);
  return sign == '!' || sign == '?' ||
         (sign == '.' && word.size() > longest_abbreviation + 1);
}

bool ends_clause(std::string_view word) {
  const auto sign = last_sign(word);
  return sign == ',' || sign == ';' || sign == ':' || ends_sentence(word);
}

// The index behind the piece that begins at `begin`.
std::size_t end_of_piece(const Words& words, std::size_t begin,
                         const PieceLength& length) {
  std::size_t size = 0;
  auto clause = begin; // behind the last clause
  for (auto i = begin; i < words.size(); ++i) {
    size += words[i].size() + 1;
    if (size > length.longest && i > begin)
      return clause > begin ? clause : i;
    if (size >= length.wanted && ends_sentence(words[i]))
      return i + 1;
    if (ends_clause(words[i]))
      clause = i + 1;
  }
  return words.size();
}

} // namespace

Words speakable_words(std::string_view text) {
  auto clean = without_invalid(text);
  blank_controls(clean);
  Words words;
  for (const auto& word : split_words(clean))
    add_in_parts(words, word);
  return words;
}

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return !continues_code_point(byte); }));
}

std::vector<Words> pieces_of(const Words& words, const PieceLength& length) {
  std::vector<Words> pieces;
  for (std::size_t at = 0; at < words.size();) {
    const auto end = end_of_piece(words, at, length);
    pieces.emplace_back(words.begin() + static_cast<std::ptrdiff_t>(at),
                        words.begin() + static_cast<std::ptrdiff_t>(end));
    at = end;
  }
  return pieces;
}

std::string joined(const Words& words) {
  std::string text;
  for (const auto& word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

} // namespace parlour::adapters::tts
