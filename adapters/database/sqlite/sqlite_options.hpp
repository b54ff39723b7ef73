// The options of SQLiteDatabase.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapters/database/database_options.hpp"
#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct SQLiteOptions : DatabaseOptions {
  // Absolute. Empty: a database in memory.
  std::filesystem::path file;

  bool in_memory() const {
    return file.empty();
  }
  SQLiteLimits limits() const {
    return {.rows = rows, .bytes = bytes};
  }
};

// The options as the plug-in's description lists them.
const std::vector<OptionDescription>& sqlite_option_descriptions();

// Reads the options. `file` is relative to the data folder and may not lie
// outside of it (docs/databases.md). An error has the kind Settings and names
// the option.
Expected<SQLiteOptions>
read_sqlite_options(const Options& options, const std::string& data_folder,
                    const std::string& application_folder);

} // namespace parlour::adapters
