#include "tools/parlour/console/bounded_line.hpp"

#include <utility>

namespace parlour::tools {

std::optional<BoundedLine> read_bounded_line(std::istream& in,
                                             std::size_t most) {
  BoundedLine line;
  for (char letter = '\0'; in.get(letter);) {
    if (letter == '\n')
      return line;
    if (line.text.size() == most) {
      in.unget();
      line.is_cut = true;
      return line;
    }
    line.text += letter;
  }
  return line.text.empty() ? std::nullopt : std::optional(std::move(line));
}

} // namespace parlour::tools
