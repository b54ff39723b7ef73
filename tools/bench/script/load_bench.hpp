// Loading a script: read, check, compile; beside what only reading its XML and
// walking over it takes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour::tools {

// `pattern` between the lines of a <dialogue>, again and again until there are
// so many bytes; every @ is the number of the repetition.
std::string repeated_script(std::string_view pattern, std::size_t bytes);

struct LoadTimes {
  double ours = 0; // nanoseconds for the file
  double parse_and_walk = 0;
};

// Each once. An error where the file has findings.
Expected<LoadTimes> load_once(const std::filesystem::path& file);

} // namespace parlour::tools
