// The page docs/reference/components.md in Markdown, as `parlour help --page
// components` prints it. A test compares the file with this output.
#pragma once

#include <string>
#include <vector>

namespace parlour::tools {

inline constexpr const char* component_page_name = "components";

// The names of all pages of the reference.
std::vector<std::string> help_pages();

// Each plug-in of the program with its options, and the commands and events
// that its roles do not have.
std::string component_page();

} // namespace parlour::tools
