// Looks at a shared library before it is mapped: the loader would run into the
// end of one that is cut off, and the program with it (SIGBUS).
#pragma once

#include <filesystem>

namespace parlour::adapters {

// Whether it ends before what it says that it holds, as after a copy that was
// interrupted. False for what is no shared library at all: the loader says so.
bool is_cut_off(const std::filesystem::path& file);

} // namespace parlour::adapters
