#include "script/text_positions.hpp"

#include <algorithm>

namespace parlour::script {

namespace {

bool continues(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
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

} // namespace parlour::script
