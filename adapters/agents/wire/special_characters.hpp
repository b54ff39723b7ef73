// Which fields of a line need quotation marks or escapes.
#pragma once

#include <string_view>

namespace parlour::adapters::agents {

// Whether a field holds a comma, a quotation mark, a line break, a carriage
// return or a backslash.
bool has_special(std::string_view field);

} // namespace parlour::adapters::agents
