// The row that `bench --only` names.
#pragma once

#include <string>
#include <vector>

#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/console.hpp"

namespace parlour::tools {

// Whether the row that is wanted, if any is, is there; says so where not.
bool has_row(const std::vector<std::string>& rows, const BenchOptions& options,
             const Console& console);

} // namespace parlour::tools
