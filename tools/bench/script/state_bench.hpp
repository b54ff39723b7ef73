// What it takes to write a session's state to bytes, and to go on from them.
#pragma once

#include <cstddef>
#include <filesystem>

#include "runtime/base/error.hpp"

namespace parlour::tools {

struct StateTimes {
  double save = 0; // nanoseconds
  double restore = 0;
  std::size_t bytes = 0;
};

// A script's `main` up to its first wait, written and read back once. An error
// where the script has findings or does not wait.
Expected<StateTimes> state_once(const std::filesystem::path& file);

} // namespace parlour::tools
