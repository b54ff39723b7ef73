// `parlour bench components`: messages through components' mailboxes, beside
// bare typed actors of CAF that do the same.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> component_bench_rows();

// False where something could not be measured; that is told in the table.
bool component_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
