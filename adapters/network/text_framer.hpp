// TextFramer splits a stream of bytes into texts: either one text for each
// line, without its "\n" or "\r\n", or texts as the bytes arrive. A character
// is never cut in two. Bytes that are not valid UTF-8 become U+FFFD.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters {

class TextFramer {
public:
  // In bytes. A longer line is delivered in pieces.
  static constexpr std::size_t longest_text = 64 << 10;

  // `lines`: one text for each line.
  explicit TextFramer(bool lines) : lines_(lines) {}

  // Adds bytes and returns the texts that are complete now.
  std::vector<std::string> take(std::string_view bytes);
  // Returns what is left at the end of the stream; empty if nothing is.
  std::string rest();

private:
  std::vector<std::string> whole_lines();
  // The number of bytes up to the end of the last complete character.
  std::size_t complete() const;

  bool lines_;
  std::string held_;
};

} // namespace parlour::adapters
