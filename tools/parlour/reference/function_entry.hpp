// Entries of the reference for built-in functions, made from
// script/expression/builtins.def.
#pragma once

#include <vector>

#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// An entry for each function, in the table's order.
std::vector<Entry> function_entries();

} // namespace parlour::tools
