#include "runtime/base/utf8.hpp"

#include <cstdint>
#include <cstring>

namespace parlour {

namespace {

bool continues(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

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

// Bytes from `i` on that are ASCII, in steps of eight.
std::size_t ascii_after(std::string_view text, std::size_t i) {
  std::uint64_t eight = 0;
  for (; i + sizeof eight <= text.size(); i += sizeof eight) {
    std::memcpy(&eight, text.data() + i, sizeof eight);
    if (eight & 0x8080808080808080u)
      break;
  }
  return i;
}

} // namespace

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  for (auto i = ascii_after(text, 0); i < text.size();
       i = ascii_after(text, i)) {
    const auto first = static_cast<unsigned char>(text[i]);
    const auto length = length_of(first);
    if (length == 0 || i + length > text.size())
      return i;
    for (std::size_t j = 1; j < length; ++j)
      if (!continues(text[i + j]))
        return i;
    if (length > 1 &&
        second_is_wrong(first, static_cast<unsigned char>(text[i + 1])))
      return i;
    i += length;
  }
  return std::nullopt;
}

} // namespace parlour
