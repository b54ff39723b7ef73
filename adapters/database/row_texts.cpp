#include "adapters/database/row_texts.hpp"

#include <cassert>
#include <cstdint>

#include <unicode/unistr.h>

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters {

namespace {

// ICU replaces each ill-formed sequence by U+FFFD while it converts to UTF-16.
void append_valid(std::string& text, std::string_view bytes) {
  const auto length = static_cast<std::int32_t>(bytes.size());
  icu::UnicodeString::fromUTF8({bytes.data(), length}).toUTF8String(text);
}

} // namespace

Value RowTexts::add(std::string_view bytes) {
  assert(count_ < max_count_);
  if (!texts_)
    texts_ = std::make_shared<std::string[]>(max_count_);
  auto& text = texts_[static_cast<std::ptrdiff_t>(count_++)];
  if (find_invalid_utf8(bytes))
    append_valid(text, bytes);
  else
    text.assign(bytes);
  // An aliasing pointer: it points to one text and owns the whole block.
  return Value(std::shared_ptr<const std::string>(texts_, &text));
}

} // namespace parlour::adapters
