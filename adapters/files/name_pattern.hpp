// Patterns of <listfiles>: in a name, '*' is any characters and '?' is one.
#pragma once

#include <string_view>

namespace parlour::adapters {

// Whether the whole of `name` fits. Names that begin with a dot never do.
// Linear in the length of the name for each '*'.
bool fits_pattern(std::string_view pattern, std::string_view name);

} // namespace parlour::adapters
