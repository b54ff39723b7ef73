// The options that every database component has, whatever its product. Each
// product derives its own options from DatabaseOptions.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/plugin/option_reader.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct DatabaseOptions {
  // SQL files that create and fill the tables of a new database. Empty: none.
  std::filesystem::path schema;
  std::filesystem::path seed;
  // How long a message waits for another's lock or for a free connection.
  Milliseconds busy_timeout{2'000};
  // After this time an open transaction is rolled back.
  Milliseconds transaction_timeout{30'000};
  // The largest result of one query, in rows and in bytes of its cells.
  std::size_t rows = 10'000;
  std::size_t bytes = 4 << 20;
  // Columns of which others are told when their values change, and how often to
  // look whether another program has changed them; zero: never.
  std::vector<std::string> columns;
  Milliseconds watch{300};
};

// Returns a product's own option descriptions followed by the common ones.
std::vector<OptionDescription>
with_database_options(std::vector<OptionDescription> own);

// Reads the common options into `made`. `schema` and `seed` are files of the
// application's folder and may not lie outside of it (docs/databases.md).
void read_database_options(OptionReader& read,
                           const std::string& application_folder,
                           DatabaseOptions& made);

} // namespace parlour::adapters
