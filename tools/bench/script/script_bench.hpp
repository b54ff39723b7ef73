// `parlour bench script`: the script engine, beside Lua 5.4 and LuaJIT's
// interpreter where they are installed, as a table.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> script_bench_rows();

// False where something could not be measured; that is told in the table.
bool script_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
