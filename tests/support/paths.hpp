// The paths of the source tree and the built program. Only paths.cpp is
// compiled with them, so that a compiler cache can share all other objects
// between clones.
#pragma once

#include <string>

namespace parlour::test {

// The absolute path of a file in the source tree, such as "config/apps".
std::string source_path(const std::string& name);
// The absolute path of the program `parlour`.
std::string program_path();

} // namespace parlour::test
