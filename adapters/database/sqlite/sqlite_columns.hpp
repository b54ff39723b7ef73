// A column's values for the understanding: "db:rr_staff.staff_name".
#pragma once

#include <string>
#include <vector>

#include "adapters/database/sqlite/sqlite_options.hpp"
#include "runtime/base/understanding.hpp"

namespace parlour::adapters {

struct ColumnReference {
  std::string table;
  std::string column;
};

// Both parts are plain names ([A-Za-z_][A-Za-z0-9_]*), so that nothing else
// ever reaches a statement. "db:" may be left out.
Expected<ColumnReference> parse_column(const std::string& reference);

// Distinct values in order, without NULL. Reads the file where it is there,
// else what schema and seed would make of it; creates nothing. From any
// thread; blocks for milliseconds.
Expected<std::vector<std::string>> read_column(const SQLiteOptions& options,
                                               const std::string& reference);

// The same for the composition root, which has the component's settings; their
// errors come with each reading.
ColumnReader sqlite_column_reader(const Options& options,
                                  const std::string& data_folder,
                                  const std::string& application_folder);

} // namespace parlour::adapters
