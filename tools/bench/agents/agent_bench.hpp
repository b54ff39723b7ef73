// `parlour bench agents`: messages between remote agents and the platform,
// compared with TCP and ZeroMQ alone; how much memory many agents need; and
// whether the audio of many microphones arrives in time.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> agent_bench_rows();

// Prints the table. False if something could not be measured.
bool agent_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
