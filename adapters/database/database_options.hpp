// The settings that every database has, described and read once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "adapters/database/option_values.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct DatabaseOptions {
  std::filesystem::path schema; // empty: none
  std::filesystem::path seed;   // empty: none
  Milliseconds busy_timeout{2'000};
  Milliseconds transaction_timeout{30'000};
  std::size_t rows = 10'000;   // of a result
  std::size_t bytes = 4 << 20; // of a result's cells
};

// A plug-in's own options, and these after them.
std::vector<OptionDescription>
with_database_options(std::vector<OptionDescription> own);

// `schema` and `seed` lie in the application's folder (docs/databases.md).
Expected<void> read_database_options(const OptionValues& values,
                                     const std::string& application_folder,
                                     DatabaseOptions& made);

} // namespace parlour::adapters
