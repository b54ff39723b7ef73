// The pages of docs/reference in Markdown, as `parlour help --page` prints
// them. A test compares the files with this output.
#pragma once

#include <string>
#include <vector>

namespace parlour::tools {

// The names of the pages: "index", "elements", "functions", "roles".
std::vector<std::string> reference_pages();

// The text of a page; the index for an unknown name.
std::string reference_page(const std::string& name);

} // namespace parlour::tools
