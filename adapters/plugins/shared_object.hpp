// Checks a shared library before it is loaded. The loader maps files without
// checking their length: a truncated one would kill the program (SIGBUS).
#pragma once

#include <filesystem>

namespace parlour::adapters {

// Whether the file is shorter than its headers say, as after an interrupted
// copy. False for a file that is no shared library, which the loader reports.
bool is_cut_off(const std::filesystem::path& file);

} // namespace parlour::adapters
