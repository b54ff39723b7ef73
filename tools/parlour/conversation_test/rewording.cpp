// Copies the text line by line and replaces the words in some lines.
#include "tools/parlour/conversation_test/rewording.hpp"

#include <algorithm>

namespace parlour::tools {

namespace {

// "  R:  old\r\n" with new words; blanks and line end stay.
std::string with_words(std::string_view line, const std::string& words) {
  const auto colon = line.find(':');
  const auto begin = line.find_first_not_of(" \t", colon + 1);
  const auto line_end = std::min(line.find_first_of("\r\n"), line.size());
  std::string made(line.substr(0, begin));
  return made.append(words).append(line.substr(line_end));
}

} // namespace

std::string reworded(std::string_view text,
                     const std::vector<Rewording>& rewordings) {
  std::string made;
  auto next = rewordings.begin();
  for (std::uint32_t number = 1; !text.empty(); ++number) {
    // The line with its end; the last line may have none.
    const auto size = std::min(text.find('\n'), text.size() - 1) + 1;
    const auto line = text.substr(0, size);
    if (next != rewordings.end() && next->line == number)
      made += with_words(line, next++->after);
    else
      made += line;
    text.remove_prefix(size);
  }
  return made;
}

} // namespace parlour::tools
