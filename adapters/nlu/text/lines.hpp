// The lines of the platform's lists: "#" begins a comment.
#pragma once

#include <string_view>
#include <vector>

namespace parlour::adapters::nlu {

// Without comments, blanks around them, and lines that are empty then. They
// refer to the text.
std::vector<std::string_view> lines_of(std::string_view text);

} // namespace parlour::adapters::nlu
