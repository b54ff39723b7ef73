// Prints an entry as a section of a page in Markdown.
#pragma once

#include <string>

#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// The heading, the sentence, the facts as a list, the details as a table, and
// the example.
std::string entry_section(const Entry& entry);

// A Markdown link to the entry's section on `page` (a file name). It uses the
// anchor that GitHub makes from the heading.
std::string link_to(const Entry& entry, const std::string& page);

} // namespace parlour::tools
