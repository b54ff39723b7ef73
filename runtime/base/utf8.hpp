// What is UTF-8: texts of sources and of everything that comes from outside.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace parlour {

// The offset of the first byte that is not UTF-8 in its shortest form without
// surrogates, if any.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

// Appends the code point in UTF-8.
void append_code_point(std::string& text, std::uint32_t code);

// Whether it is a further byte of a code point that began before.
inline bool continues_code_point(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

inline constexpr std::uint64_t highest_bits = 0x8080808080808080;

// Where from `i` on the next eight bytes begin of which one makes `unusual`
// true, all in one number; those that are too few for eight always count so.
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

// The same for bytes that are not ASCII.
inline std::size_t ascii_up_to(std::string_view text, std::size_t i) {
  return usual_up_to(text, i,
                     [](std::uint64_t eight) { return eight & highest_bits; });
}

} // namespace parlour
