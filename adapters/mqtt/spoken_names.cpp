#include "adapters/mqtt/spoken_names.hpp"

#include <algorithm>
#include <utility>

#include <unicode/uchar.h>
#include <unicode/unistr.h>

namespace parlour::adapters::mqtt {

// Marks that stand on letters belong to the word, in whatever form of Unicode
// they are written.
Words words_of(std::string_view text) {
  auto folded = icu::UnicodeString::fromUTF8(
      {text.data(), static_cast<std::int32_t>(text.size())});
  folded.foldCase();
  Words words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty())
      words.push_back(std::exchange(word, {}));
  };
  for (std::int32_t at = 0; at < folded.length();
       at = folded.moveIndex32(at, 1)) {
    const auto letter = folded.char32At(at);
    if (u_isalnum(letter) || u_charType(letter) == U_NON_SPACING_MARK)
      icu::UnicodeString(letter).toUTF8String(word);
    else
      finish();
  }
  finish();
  return words;
}

bool contains(const Words& whole, const Words& part) {
  return !part.empty() && std::search(whole.begin(), whole.end(), part.begin(),
                                      part.end()) != whole.end();
}

} // namespace parlour::adapters::mqtt
