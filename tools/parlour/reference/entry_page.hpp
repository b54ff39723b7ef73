// An entry as a section of a page, in Markdown.
#pragma once

#include <string>

#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// With its heading.
std::string entry_section(const Entry& entry);

// A link to that section of the page.
std::string link_to(const Entry& entry, const std::string& page);

} // namespace parlour::tools
