// Entries of the reference for roles and for the platform's own sources, made
// from runtime/message/roles.def.
#pragma once

#include <vector>

#include "runtime/message/roles.hpp"
#include "tools/parlour/reference/entry.hpp"

namespace parlour::tools {

// The entry of one role or source.
Entry role_entry(const Role& role);

// An entry for each role, in the table's order; the platform's own sources come
// last.
std::vector<Entry> role_entries();

} // namespace parlour::tools
