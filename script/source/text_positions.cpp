#include "script/source/text_positions.hpp"

#include <algorithm>

#include "runtime/base/text/utf8.hpp"

namespace parlour::script {

namespace {

bool is_ascii(std::string_view text) {
  const auto rest = text.substr(ascii_up_to(text, 0));
  return rest.size() < sizeof highest_bits &&
         std::none_of(rest.begin(), rest.end(),
                      [](char byte) { return (byte & 0x80) != 0; });
}

bool is_control(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte < ' ' && byte != '\t' && byte != '\r' && byte != '\n';
}

} // namespace

// Searches line feeds with find(), which is fast, and carriage returns within
// each line. A carriage return before a line feed ends no line of its own.
TextPositions::TextPositions(std::string_view text, std::uint16_t file)
    : text_(text), file_(file), is_ascii_(is_ascii(text)), starts_{0} {
  for (std::size_t begin = 0; begin < text.size(); begin = starts_.back()) {
    const auto feed = text.find('\n', begin);
    const auto line = text.substr(begin, feed - begin);
    for (auto at = line.find('\r'); at != std::string_view::npos;
         at = line.find('\r', at + 1))
      if (at + 1 < line.size() || feed == std::string_view::npos)
        starts_.push_back(begin + at + 1);
    if (feed == std::string_view::npos)
      break;
    starts_.push_back(feed + 1);
  }
}

// Starts from the last answer if the offset lies behind it in the same line or
// in the next; otherwise finds the line by binary search. Columns of ASCII text
// are bytes; otherwise continuation bytes do not count.
Position TextPositions::at(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  // The offset behind a line's end.
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
  column_ += part.size();
  if (!is_ascii_)
    column_ -= static_cast<std::size_t>(
        std::count_if(part.begin(), part.end(), continues_code_point));
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
    while (offset < text_.size() && continues_code_point(text_[offset]));
  return offset;
}

// Tests eight bytes at a time: subtracting a blank from each byte sets the
// highest bit of those below it (of the others only if it was set before, or by
// a borrow). The words found are candidates, whose bytes are then tested one by
// one.
std::optional<std::size_t> find_control_character(std::string_view text) {
  const auto low = [](std::uint64_t eight) {
    return (eight - 0x2020202020202020) & ~eight & highest_bits;
  };
  for (auto i = usual_up_to(text, 0, low); i < text.size();
       i = usual_up_to(text, i, low)) {
    const auto end = std::min(i + sizeof highest_bits, text.size());
    for (; i < end; ++i)
      if (is_control(text[i]))
        return i;
  }
  return std::nullopt;
}

} // namespace parlour::script
