// Where the tree and the built program are. Compiled into one source: a test's
// own compile line names no folder, so that a compiler cache serves every
// clone.
#pragma once

#include <string>

namespace parlour::test {

// "config/apps" below the root of the tree, as an absolute path.
std::string source_path(const std::string& name);
// The built program `parlour`, as an absolute path.
std::string program_path();

} // namespace parlour::test
