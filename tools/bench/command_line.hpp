// The command line of the program parlour-bench, which `parlour bench` starts.
#pragma once

#include <string>
#include <vector>

#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// Measures what the arguments ask for and prints the table. `arguments` do not
// include the program's name. Returns the exit status: 2 for wrong arguments, 1
// if something could not be measured.
int run_bench_command_line(std::vector<std::string> arguments,
                           const Places& places, const Console& console);

} // namespace parlour::tools
