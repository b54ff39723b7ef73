// An example's text with its marks: "I am [David](Visitor)".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::nlu {

struct MarkedText {
  struct Mark {
    std::size_t begin = 0; // bytes of the text
    std::size_t end = 0;
    std::string slot;
  };

  std::string text; // without the marks
  std::vector<Mark> marks;
};

// Nothing where brackets do not fit together.
std::optional<MarkedText> read_marks(std::string_view example);

} // namespace parlour::adapters::nlu
