// Measures how long loading a script takes (reading, checking, compiling),
// compared with only parsing its XML and walking over it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour::tools {

// A script that repeats `pattern` until it has `bytes` bytes. Each @ in the
// pattern is replaced by the number of the repetition.
std::string repeated_script(std::string_view pattern, std::size_t bytes);

// CPU time in nanoseconds.
struct LoadTimes {
  // Nanoseconds for the file.
  double ours = 0;
  double parse_and_walk = 0;
};

// Measures each once. Fails if the script has errors.
Expected<LoadTimes> load_once(const std::filesystem::path& file);

} // namespace parlour::tools
