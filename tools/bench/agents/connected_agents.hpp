// The row `connected` of `parlour bench agents`: how much memory the platform
// needs for each agent that is connected.
#pragma once

#include <iosfwd>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// Prints it for both transports. The agents are in a process of their own, so
// that their memory does not count: call it while this process has one thread.
// False if not all of them could connect.
bool connected_row(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
