// Completion of commands and options for a shell, from the command line's own
// table.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace parlour::tools {

// For bash. `values`: what an option takes, by its name ("--role"); for the
// others, and for what is no option, files and applications are offered.
std::string completion_script(
    const CLI::App& app,
    const std::map<std::string, std::vector<std::string>>& values = {});

} // namespace parlour::tools
