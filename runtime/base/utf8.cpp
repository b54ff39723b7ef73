#include "runtime/base/utf8.hpp"

namespace parlour {

namespace {

// Bytes of the code point that begins so; 0 where none does.
std::size_t length_of(unsigned char first) {
  return first < 0x80   ? 1
         : first < 0xc2 ? 0
         : first < 0xe0 ? 2
         : first < 0xf0 ? 3
         : first < 0xf5 ? 4
                        : 0;
}

// Overlong forms, surrogates, and what is beyond U+10FFFF.
bool second_is_wrong(unsigned char first, unsigned char second) {
  return (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
         (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
}

} // namespace

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  for (auto i = ascii_up_to(text, 0); i < text.size();
       i = ascii_up_to(text, i)) {
    const auto first = static_cast<unsigned char>(text[i]);
    const auto length = length_of(first);
    if (length == 0 || i + length > text.size())
      return i;
    for (std::size_t j = 1; j < length; ++j)
      if (!continues_code_point(text[i + j]))
        return i;
    if (length > 1 &&
        second_is_wrong(first, static_cast<unsigned char>(text[i + 1])))
      return i;
    i += length;
  }
  return std::nullopt;
}

} // namespace parlour
