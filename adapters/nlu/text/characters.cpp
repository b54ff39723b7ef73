#include "adapters/nlu/text/characters.hpp"

#include <unicode/normalizer2.h>
#include <unicode/uchar.h>
#include <unicode/unistr.h>
#include <unicode/utf8.h>

namespace parlour::adapters::nlu {

namespace {

bool is_ascii_alphanumeric(char32_t code) {
  return (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') ||
         (code >= '0' && code <= '9');
}

// The letter below an accent: the first character of the canonical
// decomposition.
UChar32 base_of(UChar32 code) {
  UErrorCode status = U_ZERO_ERROR;
  const auto* normalizer = icu::Normalizer2::getNFDInstance(status);
  icu::UnicodeString parts;
  if (U_SUCCESS(status) && normalizer->getDecomposition(code, parts))
    return parts.char32At(0);
  return code;
}

} // namespace

Character character_at(std::string_view text, std::size_t position) {
  const auto first = static_cast<unsigned char>(text[position]);
  if (first < 0x80)
    return {first, 1};
  const auto rest = text.substr(position, 4);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(rest.data());
  const auto size = static_cast<std::int32_t>(rest.size());
  std::int32_t at = 0;
  UChar32 code = 0;
  U8_NEXT(bytes, at, size, code);
  if (code < 0)
    return {0xFFFD, 1};
  return {static_cast<char32_t>(code), static_cast<std::uint32_t>(at)};
}

bool is_word_character(char32_t code) {
  if (code < 0x80)
    return is_ascii_alphanumeric(code);
  const auto wide = static_cast<UChar32>(code);
  return u_isalnum(wide) || u_charType(wide) == U_NON_SPACING_MARK;
}

bool is_upper(char32_t code) {
  return code < 0x80 ? code >= 'A' && code <= 'Z'
                     : u_isupper(static_cast<UChar32>(code)) != 0;
}

void append_folded(std::string& word, char32_t code) {
  if (code < 0x80) {
    word += static_cast<char>(code >= 'A' && code <= 'Z' ? code + 32 : code);
    return;
  }
  const auto wide = static_cast<UChar32>(code);
  if (u_charType(wide) == U_NON_SPACING_MARK)
    return;
  icu::UnicodeString folded(u_foldCase(base_of(wide), U_FOLD_CASE_DEFAULT));
  folded.toUTF8String(word);
}

} // namespace parlour::adapters::nlu
