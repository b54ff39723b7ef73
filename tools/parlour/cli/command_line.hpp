// The command line of `parlour`: parses the arguments, calls the chosen command
// (commands.hpp, plugin_commands.hpp) and returns its exit status.
//
// To add a command: declare its options and function in commands.hpp, define
// the function in cli/x_command.cpp, and register it in command_line.cpp.
#pragma once

#include <string>
#include <vector>

#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// `arguments` does not contain the program's name. Wrong usage is reported on
// `console.err` and gives status 2 (exit_code.hpp); --help and --version print
// to `console.out` and give 0. Blocks until the command has ended. `places` is
// copied, because --plugins changes it; `console` must outlive the call.
int run_command_line(std::vector<std::string> arguments, const Places& places,
                     const Console& console);

} // namespace parlour::tools
