#include "script/text_positions.hpp"

#include <algorithm>

namespace parlour::script {

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

} // namespace

TextPositions::TextPositions(std::string_view text, std::uint16_t file)
    : text_(text), file_(file), starts_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool lone_return =
        text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
    if (text[i] == '\n' || lone_return)
      starts_.push_back(i + 1);
  }
}

Position TextPositions::at(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto start = *(next - 1);
  const auto part = text_.substr(start, offset - start);
  const auto inside = std::count_if(part.begin(), part.end(), continues);
  return {file_, static_cast<std::uint32_t>(next - starts_.begin()),
          static_cast<std::uint32_t>(part.size() -
                                     static_cast<std::size_t>(inside) + 1)};
}

std::size_t TextPositions::offset_of(std::uint32_t line,
                                     std::uint32_t column) const {
  if (line == 0 || line > starts_.size())
    return text_.size();
  auto offset = starts_[line - 1];
  for (; column > 1 && offset < text_.size(); --column)
    do
      ++offset;
    while (offset < text_.size() && continues(text_[offset]));
  return offset;
}

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
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

} // namespace parlour::script
