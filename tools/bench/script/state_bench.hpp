// Measures how long it takes to write a session's state to bytes and to restore
// it.
#pragma once

#include <cstddef>
#include <filesystem>

#include "runtime/base/error.hpp"

namespace parlour::tools {

// CPU time, and the size of the state.
struct StateTimes {
  // Nanoseconds.
  double save = 0;
  double restore = 0;
  std::size_t bytes = 0;
};

// Runs a script's `main` up to its first wait, saves it and restores it once.
// Fails if the script has errors or does not wait.
Expected<StateTimes> state_once(const std::filesystem::path& file);

} // namespace parlour::tools
