// Reads an example's text with its marks: "I am [David](Visitor)".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::nlu {

struct MarkedText {
  struct Mark {
    // Bytes of `text`.
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string slot;
  };

  // Without the marks.
  std::string text;
  std::vector<Mark> marks;
};

// Nothing if the brackets do not fit together.
std::optional<MarkedText> read_marks(std::string_view example);

} // namespace parlour::adapters::nlu
