// The settings of an SQLite database, read once.
#pragma once

#include <filesystem>
#include <string>

#include "adapters/database/sqlite_connection.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct SQLiteOptions {
  std::filesystem::path file;   // empty: in memory
  std::filesystem::path schema; // empty: none
  std::filesystem::path seed;   // empty: none
  Milliseconds busy_timeout{};
  Milliseconds transaction_timeout{};
  SQLiteLimits limits;

  bool in_memory() const {
    return file.empty();
  }
};

// What the plug-in's description says about them.
const std::vector<OptionDescription>& sqlite_option_descriptions();

// `file` is taken relative to the data folder, `schema` and `seed` to the
// application's, and none may leave it (language rule 1). An error of kind
// Settings names the option that is wrong.
Expected<SQLiteOptions>
read_sqlite_options(const Options& options, const std::string& data_folder,
                    const std::string& application_folder);

} // namespace parlour::adapters
