// `parlour bench dialogue`: the dialogue engine alone, compared with the same
// dialogue written by hand in Lua, where Lua is installed.
//
//  turns   a user turn: acts in, a question or an answer out
//  events  an event that a state machine takes under a condition
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> dialogue_bench_rows();

// Prints the table. False if something could not be measured.
bool dialogue_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
