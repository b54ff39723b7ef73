#include "script/text_positions.hpp"

#include <algorithm>
#include <cstring>

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
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n' ||
        (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')))
      starts_.push_back(i + 1);
}

Position TextPositions::at(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto ends = [this](std::size_t line) {
    return line + 1 < starts_.size() ? starts_[line + 1] : text_.size() + 1;
  };
  if (offset < offset_ || offset >= ends(line_)) {
    if (offset < offset_ || offset >= ends(line_ + 1))
      line_ = static_cast<std::size_t>(
          std::upper_bound(starts_.begin(), starts_.end(), offset) -
          starts_.begin() - 1);
    else
      ++line_;
    offset_ = starts_[line_];
    column_ = 0;
  }
  const auto part = text_.substr(offset_, offset - offset_);
  column_ += part.size() - static_cast<std::size_t>(std::count_if(
                               part.begin(), part.end(), continues));
  offset_ = offset;
  return {file_, static_cast<std::uint32_t>(line_ + 1),
          static_cast<std::uint32_t>(column_ + 1)};
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

namespace {

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

} // namespace parlour::script
