// Generates the completion script of a shell from the parsed command line, so
// that it never differs from the options that there are.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace parlour::tools {

// The script for bash; `parlour completion bash` prints it. `values` lists the
// values of an option ("--role") or of a command's argument ("help"). Where
// nothing is listed, files and the folders of ./config/apps are offered. Hidden
// commands and options are left out.
std::string completion_script(
    const CLI::App& app,
    const std::map<std::string, std::vector<std::string>>& values = {});

} // namespace parlour::tools
