// `parlour bench dialogue`: the dialogue engine alone, beside the same by hand
// in Lua where it is installed, as a table.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> dialogue_bench_rows();

// False where something could not be measured; that is told in the table.
bool dialogue_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
