// Checking and writing UTF-8. Source texts and everything that comes from
// outside are checked before use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace parlour {

// The offset of the first byte that is not valid UTF-8, if any. Overlong forms,
// surrogates and code points beyond U+10FFFF are invalid.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

// Appends the code point, encoded in UTF-8.
void append_code_point(std::string& text, std::uint32_t code);

// Whether the byte is a continuation byte: not the first of its code point.
inline bool continues_code_point(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

// The functions below scan a text eight bytes at a time, in one machine word.
inline constexpr std::uint64_t highest_bits = 0x8080808080808080;

// The first offset from `i` on, in steps of eight, at which the next eight
// bytes are `unusual` or fewer than eight bytes are left. `unusual` gets them
// as one number.
template <class Predicate>
std::size_t usual_up_to(std::string_view text, std::size_t i,
                        Predicate unusual) {
  std::uint64_t eight = 0;
  for (; i + sizeof eight <= text.size(); i += sizeof eight) {
    std::memcpy(&eight, text.data() + i, sizeof eight);
    if (unusual(eight))
      break;
  }
  return i;
}

// The same for text that is not ASCII: the highest bit of a byte is set.
inline std::size_t ascii_up_to(std::string_view text, std::size_t i) {
  return usual_up_to(text, i,
                     [](std::uint64_t eight) { return eight & highest_bits; });
}

} // namespace parlour
