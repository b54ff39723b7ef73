// `parlour bench script`: the script engine, compared with Lua 5.4 and the
// interpreter of LuaJIT where they are installed. Besides the rows that Lua
// has, too, it measures:
//
//  switch     whether a choice becomes slower with more arms
//  suspended  the memory of a script that waits
//  state      saving and restoring a session
//  load       loading a script of 100 KB
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> script_bench_rows();

// Prints the table. False if something could not be measured.
bool script_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
