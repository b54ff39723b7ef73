#include "runtime/base/text/utf8.hpp"

namespace parlour {

namespace {

// The length of a code point by its first byte; 0 for a byte that cannot be
// first.
std::size_t length_of(unsigned char first) {
  return first < 0x80   ? 1
         : first < 0xc2 ? 0
         : first < 0xe0 ? 2
         : first < 0xf0 ? 3
         : first < 0xf5 ? 4
                        : 0;
}

// Byte ranges of the Unicode standard, table 3-7: the second byte rules out
// overlong forms, surrogates and code points beyond U+10FFFF.
bool second_is_wrong(unsigned char first, unsigned char second) {
  return (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
         (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
}

// One pass over whole words. The last eight bytes may overlap the words before,
// which is faster than a loop over the remaining bytes.
bool is_ascii(std::string_view text) {
  std::uint64_t all = 0;
  std::uint64_t eight = 0;
  if (text.size() < sizeof eight) {
    for (const char byte : text)
      all |= static_cast<unsigned char>(byte);
    return all < 0x80;
  }
  for (std::size_t i = 0; i + sizeof eight < text.size(); i += sizeof eight) {
    std::memcpy(&eight, text.data() + i, sizeof eight);
    all |= eight;
  }
  std::memcpy(&eight, text.data() + text.size() - sizeof eight, sizeof eight);
  return ((all | eight) & highest_bits) == 0;
}

} // namespace

// Most texts are ASCII or nearly so: skips ASCII by words and checks each other
// code point byte by byte.
std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  if (is_ascii(text))
    return std::nullopt;
  // Each round begins at a code point.
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

void append_code_point(std::string& text, std::uint32_t code) {
  auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6);
    put(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    put(0xe0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3f));
    put(0x80 | (code & 0x3f));
  } else {
    put(0xf0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3f));
    put(0x80 | (code >> 6 & 0x3f));
    put(0x80 | (code & 0x3f));
  }
}

} // namespace parlour
