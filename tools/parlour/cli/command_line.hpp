// The command line: parses it, calls the command, gives the exit status.
#pragma once

#include <string>
#include <vector>

#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// `arguments` without the program's name. Wrong usage is told on `err`, with
// status 2; --help and --version on `out`, with status 0.
int run_command_line(std::vector<std::string> arguments, const Places& places,
                     const Console& console);

} // namespace parlour::tools
