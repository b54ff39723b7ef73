// The settings of an SQLite database, read once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapters/database/database_options.hpp"
#include "adapters/database/sqlite/sqlite_connection.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

struct SQLiteOptions : DatabaseOptions {
  std::filesystem::path file; // empty: in memory

  bool in_memory() const {
    return file.empty();
  }
  SQLiteLimits limits() const {
    return {.rows = rows, .bytes = bytes};
  }
};

// What the plug-in's description says about them.
const std::vector<OptionDescription>& sqlite_option_descriptions();

// `file` is taken relative to the data folder, which it may not leave
// (docs/databases.md). An error of kind Settings names the option that is
// wrong.
Expected<SQLiteOptions>
read_sqlite_options(const Options& options, const std::string& data_folder,
                    const std::string& application_folder);

} // namespace parlour::adapters
