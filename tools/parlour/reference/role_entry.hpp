// Entries of roles and of the platform's own sources, from
// runtime/base/roles.def.
#pragma once

#include <vector>

#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// Of each role, in the table's order; the platform's own sources last.
std::vector<Entry> role_entries();

} // namespace parlour::tools
