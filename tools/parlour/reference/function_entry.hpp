// Entries of built-in functions, from script/expression/builtins.def.
#pragma once

#include <vector>

#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// Of each function, in the table's order.
std::vector<Entry> function_entries();

} // namespace parlour::tools
