#include "adapters/network/text_framer.hpp"

#include <cstdint>
#include <utility>

#include <unicode/unistr.h>
#include <unicode/utf8.h>

namespace parlour::adapters {

namespace {

// ICU replaces each ill-formed sequence by U+FFFD.
std::string valid_text(std::string_view bytes) {
  std::string text;
  icu::UnicodeString::fromUTF8(
      {bytes.data(), static_cast<std::int32_t>(bytes.size())})
      .toUTF8String(text);
  return text;
}

std::string_view without_return(std::string_view line) {
  if (line.ends_with('\r'))
    line.remove_suffix(1);
  return line;
}

} // namespace

std::vector<std::string> TextFramer::take(std::string_view bytes) {
  held_ += bytes;
  auto texts = lines_ ? whole_lines() : std::vector<std::string>();
  // Whatever is complete is a text if lines do not matter, or if the current
  // line has grown too long.
  if (const auto size = complete();
      size > 0 && (!lines_ || held_.size() > longest_text)) {
    texts.push_back(valid_text(std::string_view(held_).substr(0, size)));
    held_.erase(0, size);
  }
  return texts;
}

std::vector<std::string> TextFramer::whole_lines() {
  std::vector<std::string> lines;
  std::size_t start = 0;
  for (auto end = held_.find('\n'); end != std::string::npos;
       end = held_.find('\n', start)) {
    const auto line = std::string_view(held_).substr(start, end - start);
    lines.push_back(valid_text(without_return(line)));
    start = end + 1;
  }
  held_.erase(0, start);
  return lines;
}

// A character has at most 4 bytes, so only the last 3 bytes can be the
// beginning of an incomplete one. The loop looks for its lead byte.
std::size_t TextFramer::complete() const {
  for (std::size_t back = 1; back <= 3 && back <= held_.size(); ++back) {
    const auto at = held_.size() - back;
    const auto byte = static_cast<std::uint8_t>(held_[at]);
    if (U8_IS_LEAD(byte))
      return static_cast<std::size_t>(U8_COUNT_TRAIL_BYTES(byte)) >= back
                 ? at
                 : held_.size();
    if (!U8_IS_TRAIL(byte))
      break;
  }
  return held_.size();
}

std::string TextFramer::rest() {
  return valid_text(std::exchange(held_, {}));
}

} // namespace parlour::adapters
