#include "adapters/tts/plain_words.hpp"

#include <algorithm>
#include <memory>

#include <unicode/translit.h>
#include <unicode/unistr.h>

namespace parlour::adapters::tts {

namespace {

// Null if ICU lacks its data.
std::unique_ptr<icu::Transliterator> make_transliterator() {
  UErrorCode error = U_ZERO_ERROR;
  return std::unique_ptr<icu::Transliterator>(
      icu::Transliterator::createInstance("Any-Latin; Latin-ASCII",
                                          UTRANS_FORWARD, error));
}

bool is_plain(char byte) {
  return byte > ' ' && byte < '\x7f';
}

} // namespace

std::string in_plain_letters(const std::string& word) {
  if (std::ranges::all_of(word, is_plain))
    return word;
  static const auto transliterator = make_transliterator();
  auto text = icu::UnicodeString::fromUTF8(word);
  if (transliterator)
    transliterator->transliterate(text);
  std::string plain;
  text.toUTF8String(plain);
  std::erase_if(plain, [](char byte) { return !is_plain(byte); });
  return plain;
}

} // namespace parlour::adapters::tts
