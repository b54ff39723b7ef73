// The patterns of <listfiles>: '*' stands for any characters and '?' for one.
#pragma once

#include <string_view>

namespace parlour::adapters {

// Whether the whole name fits. A name that begins with a dot never does. Time:
// length of the name x number of '*' at most.
bool fits_pattern(std::string_view pattern, std::string_view name);

} // namespace parlour::adapters
