// A UTF-8 decoder by byte, which replaces invalid sequences by U+FFFD.
#include "tools/parlour/console/line_reader.hpp"

#include <algorithm>
#include <utility>

namespace parlour::tools {

namespace {

unsigned char byte_at(const std::string& text, std::size_t index) {
  return static_cast<unsigned char>(text[index]);
}

// The number of bytes of a character whose first byte this is, or 0 if no
// character begins so: ASCII, a continuation byte, or C0, C1, F5 to FF.
std::size_t size_of_sequence(unsigned char first) {
  if (first >= 0xC2 && first <= 0xDF)
    return 2;
  if ((first & 0xF0) == 0xE0)
    return 3;
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

// Whether `next` may continue the sequence (The Unicode Standard, table 3-7).
// The second byte's range excludes overlong forms, surrogates and code points
// beyond U+10FFFF.
bool may_follow(const std::string& sequence, unsigned char next) {
  if (sequence.size() > 1)
    return next >= 0x80 && next <= 0xBF;
  switch (byte_at(sequence, 0)) {
  case 0xE0:
    return next >= 0xA0 && next <= 0xBF;
  case 0xED:
    return next >= 0x80 && next <= 0x9F;
  case 0xF0:
    return next >= 0x90 && next <= 0xBF;
  case 0xF4:
    return next >= 0x80 && next <= 0x8F;
  default:
    return next >= 0x80 && next <= 0xBF;
  }
}

} // namespace

std::optional<Line> LineReader::take(std::string_view& bytes) {
  while (!bytes.empty()) {
    const auto byte = bytes.front();
    bytes.remove_prefix(1);
    if (byte == '\n')
      return give();
    begun_ = true;
    add(byte);
  }
  return std::nullopt;
}

std::optional<Line> LineReader::finish() {
  if (!begun_)
    return std::nullopt;
  return give();
}

// `sequence_` holds the valid start of a character. A byte either continues it,
// or the start is replaced and the byte is looked at anew.
void LineReader::add(char byte) {
  const auto value = static_cast<unsigned char>(byte);
  if (!sequence_.empty() && may_follow(sequence_, value)) {
    sequence_ += byte;
    if (sequence_.size() == size_of_sequence(byte_at(sequence_, 0))) {
      count_character();
      if (!line_.cut)
        line_.text += sequence_;
      sequence_.clear();
    }
    return;
  }
  flush_sequence();
  // A NUL would cut the text in C interfaces, so it is replaced, too.
  if (size_of_sequence(value) > 0)
    sequence_ = byte;
  else if (value >= 0x80 || value == 0)
    add_replacement();
  else if (count_character(); !line_.cut)
    line_.text += byte;
}

// Adds one U+FFFD for each maximal invalid part of the input (The Unicode
// Standard, section 3.9).
void LineReader::add_replacement() {
  count_character();
  line_.repaired = true;
  if (!line_.cut)
    line_.text += "\xEF\xBF\xBD";
}

void LineReader::count_character() {
  if (characters_ == longest_line)
    line_.cut = true;
  else
    ++characters_;
}

void LineReader::flush_sequence() {
  if (!sequence_.empty())
    add_replacement();
  sequence_.clear();
}

Line LineReader::give() {
  flush_sequence();
  auto line = std::exchange(line_, {});
  characters_ = 0;
  begun_ = false;
  // CR LF ends a line as well.
  if (!line.text.empty() && line.text.back() == '\r')
    line.text.pop_back();
  return line;
}

bool is_blank(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c == ' ' || (c >= 9 && c <= 13); });
}

} // namespace parlour::tools
