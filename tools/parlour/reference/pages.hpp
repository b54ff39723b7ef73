// The pages of docs/reference, as Markdown.
#pragma once

#include <string>
#include <vector>

namespace parlour::tools {

// "elements", "functions", "roles", "index".
std::vector<std::string> reference_pages();

// The text of one of them.
std::string reference_page(const std::string& name);

} // namespace parlour::tools
