// ICU does the mapping; the root locale is used.

#include "script/spoken/letter_case.hpp"

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

} // namespace

std::optional<std::string> capitals(std::string_view text) {
  return mapped(text, ucasemap_utf8ToUpper);
}

std::optional<std::string> small_letters(std::string_view text) {
  return mapped(text, ucasemap_utf8ToLower);
}

} // namespace parlour::script
