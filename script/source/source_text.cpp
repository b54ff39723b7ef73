#include "script/source/source_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>
#include <utility>

#include "runtime/base/text/utf8.hpp"
#include "script/source/text_positions.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
constexpr std::string_view blanks = " \t\r\n";

bool is_blank(char letter) {
  return blanks.find(letter) != npos;
}

bool is_word_byte(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return std::isalnum(byte) || letter == '_' || byte >= 0x80;
}

std::size_t end_of_word(std::string_view text, std::size_t offset) {
  while (offset < text.size() && is_word_byte(text[offset]))
    ++offset;
  return offset;
}

// The closing quote if an attribute's value begins at this offset; else npos.
std::size_t end_of_value(std::string_view text, std::size_t begin) {
  if (begin == 0 || (text[begin - 1] != '"' && text[begin - 1] != '\''))
    return npos;
  const auto before = text.substr(0, begin - 1).find_last_not_of(blanks);
  return before != npos && text[before] == '='
             ? text.find(text[begin - 1], begin)
             : npos;
}

// A piece of the file and the number of bytes of the value that it makes.
struct Piece {
  std::size_t length = 1;
  std::size_t value = 1;
};

// How many bytes of UTF-8 "&#233;" or "&#xe9;" stands for.
std::size_t bytes_of_reference(std::string_view entity) {
  const bool hexadecimal = entity.starts_with("&#x");
  const auto* first = entity.data() + (hexadecimal ? 3 : 2);
  std::uint32_t code = 0;
  std::from_chars(first, entity.data() + entity.size(), code,
                  hexadecimal ? 16 : 10);
  std::string bytes;
  append_code_point(bytes, code);
  return bytes.size();
}

// The first piece of the text: a line end, a comment or CDATA mark (which add
// nothing to the value), an entity (the named ones stand for one byte), or a
// single byte. An entity has at most ten characters before its semicolon.
Piece piece_at(std::string_view text) {
  constexpr std::string_view section = "<![CDATA[";
  if (text.starts_with("\r\n"))
    return {2, 1};
  if (text.starts_with("<!--"))
    return {std::min(text.find("-->"), text.size() - 3) + 3, 0};
  if (text.starts_with(section))
    return {section.size(), 0};
  if (text.starts_with("]]>"))
    return {3, 0};
  const auto end = text.starts_with('&') ? text.find(';') : npos;
  if (end > 10)
    return {};
  return {end + 1,
          text[1] == '#' ? bytes_of_reference(text.substr(0, end)) : 1};
}

} // namespace

SourceText::SourceText(std::string text)
    : text_(std::move(text)),
      mark_(text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0) {}
// The cached positions point into the text, so they are not moved along.
SourceText::SourceText(SourceText&& other) noexcept
    : text_(std::move(other.text_)), mark_(other.mark_) {}
SourceText& SourceText::operator=(SourceText&& other) noexcept {
  text_ = std::move(other.text_);
  mark_ = other.mark_;
  positions_.reset();
  return *this;
}
SourceText::~SourceText() = default;

const TextPositions& SourceText::positions() const {
  if (!positions_)
    positions_ = std::make_unique<TextPositions>(
        std::string_view(text_).substr(mark_), std::uint16_t{0});
  return *positions_;
}

// Positions do not count the byte order mark; offsets do.
std::size_t SourceText::offset_of(Position position) const {
  return positions().offset_of(position.line, position.column) + mark_;
}

Position SourceText::at(std::size_t offset) const {
  return positions().at(std::max(offset, mark_) - mark_);
}

// Walks over the pieces and counts the bytes of the value until `skip` of them
// lie behind. Pieces without bytes are passed, so that the result is at visible
// text.
std::size_t SourceText::inside(std::size_t start, std::size_t skip,
                               bool collapsed) const {
  const auto text = std::string_view(text_);
  auto offset = start;
  bool after_blank = collapsed; // leading blanks are dropped
  for (std::size_t done = 0; offset < text.size();) {
    const auto piece = piece_at(text.substr(offset));
    auto value = piece.value;
    if (collapsed && value > 0) {
      const bool blank = is_blank(text[offset]);
      value = blank && after_blank ? 0 : value;
      after_blank = blank;
    }
    // This piece contains the byte that was asked for.
    if (value > 0 && done + value > skip)
      break;
    done += value;
    offset += piece.length;
  }
  return std::min(offset, text.size());
}

std::size_t SourceText::end_of(std::size_t begin) const {
  const auto text = std::string_view(text_);
  if (begin >= text.size())
    return text.size();
  if (const auto end = end_of_value(text, begin); end != npos && end > begin)
    return end;
  if (text[begin] == '<') {
    const auto name = begin + (text.substr(begin).starts_with("</") ? 2 : 1);
    const auto end = end_of_word(text, name);
    return end < text.size() && text[end] == '>' ? end + 1 : end;
  }
  auto end = end_of_word(text, begin);
  while (end > begin && end < text.size() && text[end] == '-' &&
         is_word_byte(text[begin])) // attribute names have hyphens
    end = end_of_word(text, end + 1);
  return end > begin ? end : begin + 1;
}

} // namespace parlour::script
