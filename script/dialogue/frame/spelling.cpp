#include "script/dialogue/frame/spelling.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include <unicode/uchar.h>
#include <unicode/unistr.h>

#include "runtime/text/edit_distance.hpp"

namespace parlour::dialogue {

namespace {

// The distance of the same words in another order or number. Wrong letters
// count on top of it, so a plural is nearer than any misspelling.
constexpr int same_words = 1;

bool has_digit(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

// Letters that may differ in so long a word or name; the length is in letters
// of the shorter one. In short words one letter makes another word ("tea",
// "ten"); with more in long ones, different names would meet.
int tolerance(std::size_t length) {
  return length < 4 ? 0 : length < 8 ? 1 : length < 13 ? 2 : 3;
}

// In bytes; what is longer is near only to itself. It bounds the memory and
// time of one comparison.
constexpr std::size_t longest = 200;

// Letters as they are compared.
std::u16string letters_of(const std::string& text) {
  const auto unicode = icu::UnicodeString::fromUTF8(text);
  return {unicode.getBuffer(), static_cast<std::size_t>(unicode.length())};
}

// Of UTF-8: the bytes that begin one.
std::size_t letter_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// With digits, one letter is another thing: room 201 is not room 210.
std::optional<int> near(const std::string& a, const std::string& b) {
  if (a == b)
    return 0;
  const auto allowed = tolerance(std::min(letter_count(a), letter_count(b)));
  if (allowed == 0 || has_digit(a) || has_digit(b) ||
      std::max(a.size(), b.size()) > longest)
    return std::nullopt;
  const auto distance =
      edit_distance<longest>(letters_of(a), letters_of(b), allowed);
  return distance <= allowed ? std::optional(distance) : std::nullopt;
}

bool ends_with(std::string_view word, std::string_view end) {
  return word.size() > end.size() + 1 && word.ends_with(end);
}

// A rough rule of English, applied to both sides: what it does to a word need
// not be right, only equal.
std::string singular(std::string word) {
  if (ends_with(word, "ies"))
    return word.substr(0, word.size() - 3) + "y";
  for (const auto* end : {"ches", "shes", "sses", "xes"})
    if (ends_with(word, end))
      return word.substr(0, word.size() - 2);
  if (ends_with(word, "s") && !ends_with(word, "ss"))
    word.pop_back();
  return word;
}

std::vector<std::string> singulars(std::vector<std::string> words) {
  for (auto& word : words)
    word = singular(std::move(word));
  return words;
}

std::vector<std::string> sorted(std::vector<std::string> words) {
  std::sort(words.begin(), words.end());
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  return std::accumulate(words.begin(), words.end(), std::string());
}

// Each word to the nearest one that is left, in any order. Greedy: a better
// assignment of later words is not looked for.
std::optional<int> word_by_word(const std::vector<std::string>& said,
                                std::vector<std::string> canonical) {
  int sum = 0;
  for (const auto& word : said) {
    std::optional<int> best;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < canonical.size(); ++i) {
      auto distance = near(word, canonical[i]);
      if (distance && (!best || *distance < *best)) {
        best = distance;
        chosen = i;
      }
    }
    if (!best)
      return std::nullopt;
    sum += *best;
    canonical.erase(canonical.begin() + static_cast<std::ptrdiff_t>(chosen));
  }
  return sum;
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<signed char>(c) >= 0; });
}

// The same as below, for the letters that most texts are made of.
// Gives what is left of it letter by letter, while that is wanted; false: it
// was no longer.
template <class Give>
bool fold_ascii(std::string_view text, Give give) {
  bool gap = false;
  bool begun = false;
  for (char letter : text) {
    if (letter == '\'')
      continue;
    if (letter >= 'A' && letter <= 'Z')
      letter = static_cast<char>(letter | 0x20);
    const bool shown =
        (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    if (shown && ((gap && begun && !give(' ')) || !give(letter)))
      return false;
    begun = begun || shown;
    gap = !shown;
  }
  return true;
}

std::string folded_ascii(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  fold_ascii(text, [&](char letter) {
    result += letter;
    return true;
  });
  return result;
}

std::string folded_unicode(std::string_view text) {
  auto unicode = icu::UnicodeString::fromUTF8(
      icu::StringPiece(text.data(), static_cast<std::int32_t>(text.size())));
  unicode.foldCase();
  icu::UnicodeString result;
  bool gap = false;
  for (std::int32_t i = 0; i < unicode.length();
       i = unicode.moveIndex32(i, 1)) {
    auto letter = unicode.char32At(i);
    if (letter == '\'' || letter == 0x2019)
      continue; // "Jeffery's" is one word
    if (u_isalnum(letter) || u_charType(letter) == U_NON_SPACING_MARK) {
      if (gap && !result.isEmpty())
        result.append(u' ');
      result.append(letter);
      gap = false;
    } else {
      gap = true;
    }
  }
  std::string utf8;
  result.toUTF8String(utf8);
  return utf8;
}

} // namespace

std::string folded(std::string_view text) {
  return is_ascii(text) ? folded_ascii(text) : folded_unicode(text);
}

bool folds_to(std::string_view text, std::string_view words) {
  if (!is_ascii(text))
    return folded_unicode(text) == words;
  std::size_t at = 0;
  const bool begins_so = fold_ascii(text, [&](char letter) {
    return at < words.size() && words[at++] == letter;
  });
  return begins_so && at == words.size();
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  const auto all = folded(text);
  for (std::size_t from = 0; from < all.size();) {
    auto to = std::min(all.find(' ', from), all.size());
    words.push_back(all.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

std::optional<int> spelling_distance(std::string_view said,
                                     std::string_view canonical) {
  const auto plain_said = words_of(said);
  const auto plain_canonical = words_of(canonical);
  if (plain_said == plain_canonical)
    return plain_said.empty() && said != canonical ? std::nullopt
                                                   : std::optional(0);
  const auto a = singulars(plain_said);
  const auto b = singulars(plain_canonical);
  if (sorted(a) == sorted(b))
    return same_words;
  // "foodcourt" is two words said as one.
  auto distance =
      a.size() == b.size() ? word_by_word(a, b) : near(joined(a), joined(b));
  return distance ? std::optional(*distance + same_words + 1) : std::nullopt;
}

bool has_words(std::string_view whole, std::string_view part) {
  auto words = words_of(whole);
  const auto wanted = words_of(part);
  return !wanted.empty() &&
         std::all_of(wanted.begin(), wanted.end(), [&](const auto& word) {
           return std::find(words.begin(), words.end(), word) != words.end();
         });
}

} // namespace parlour::dialogue
