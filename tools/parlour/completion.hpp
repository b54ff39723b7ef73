// Completion of commands and options for a shell, from the command line's own
// table.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace parlour::tools {

// For bash.
std::string completion_script(const CLI::App& app);

} // namespace parlour::tools
