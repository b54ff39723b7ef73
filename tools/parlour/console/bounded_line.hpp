// Lines of an input that may be anything: a device without a line's end, too.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>

namespace parlour::tools {

struct BoundedLine {
  std::string text; // without its end
  bool is_cut = false;
};

// The next line, of at most `most` bytes; nothing at the end. Of a line that is
// cut the rest is still to be read. Waits for a line, and no longer.
std::optional<BoundedLine> read_bounded_line(std::istream& in,
                                             std::size_t most);

} // namespace parlour::tools
