// TextFramer: the bytes of a stream as texts: a text for each line, without its
// end ("\n" or "\r\n"), or texts as they came. A character is never cut in two;
// bytes that are not UTF-8 become U+FFFD.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters {

class TextFramer {
public:
  // A longer line comes in pieces.
  static constexpr std::size_t longest_text = 64 << 10;

  explicit TextFramer(bool lines) : lines_(lines) {}

  std::vector<std::string> take(std::string_view bytes);
  // The stream is over: what is left; empty: nothing.
  std::string rest();

private:
  std::vector<std::string> whole_lines();
  std::size_t complete() const; // bytes up to the last whole character

  bool lines_;
  std::string held_;
};

} // namespace parlour::adapters
