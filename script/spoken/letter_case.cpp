// ICU does the mapping; the root locale is used. Plain ASCII, which most texts
// are, is mapped here: scripts do it for each word of each row.

#include "script/spoken/letter_case.hpp"

#include <algorithm>

#include <unicode/ucasemap.h>

namespace parlour::script {

namespace {

using Mapping = int32_t (*)(const UCaseMap*, char*, int32_t, const char*,
                            int32_t, UErrorCode*);

std::optional<std::string> mapped(std::string_view text, Mapping mapping) {
  // It is never changed, so all threads may share it.
  static const icu::LocalUCaseMapPointer casemap([] {
    auto error = U_ZERO_ERROR;
    return ucasemap_open("", 0, &error);
  }());
  // No mapping makes a character more than three times as long.
  std::string result(text.size() * 3 + 1, '\0');
  auto error = U_ZERO_ERROR;
  const auto size = mapping(casemap.getAlias(), result.data(),
                            static_cast<int32_t>(result.size()), text.data(),
                            static_cast<int32_t>(text.size()), &error);
  if (U_FAILURE(error))
    return {};
  result.resize(static_cast<std::size_t>(size));
  return result;
}

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(
      text, [](char one) { return static_cast<unsigned char>(one) < 0x80; });
}

// Moves the letters from `first` on, of which there are 26, to `target`.
std::string moved(std::string_view text, char first, char target) {
  std::string result(text);
  for (auto& one : result)
    if (one >= first && one < first + 26)
      one = static_cast<char>(one - first + target);
  return result;
}

} // namespace

std::optional<std::string> capitals(std::string_view text) {
  return is_ascii(text) ? moved(text, 'a', 'A')
                        : mapped(text, ucasemap_utf8ToUpper);
}

std::optional<std::string> small_letters(std::string_view text) {
  return is_ascii(text) ? moved(text, 'A', 'a')
                        : mapped(text, ucasemap_utf8ToLower);
}

} // namespace parlour::script
