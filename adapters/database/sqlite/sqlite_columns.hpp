// Reads the distinct values of one column of an SQLite database. Language
// understanding uses them as the vocabulary of a slot whose cardinality names a
// column, such as "db:rr_staff.staff_name".
#pragma once

#include <string>
#include <vector>

#include "adapters/database/sqlite/sqlite_options.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters {

// The distinct values in ascending order, without NULL, over a connection that
// is open.
Expected<std::vector<std::string>> read_column(SQLiteConnection& connection,
                                               const std::string& reference);

// The same of the database file if it exists, else of that which schema and
// seed would create; creates no file. Thread-safe; blocks for some
// milliseconds.
Expected<std::vector<std::string>> read_column(const SQLiteOptions& options,
                                               const std::string& reference);

// The same as a function with the component's options bound to it. An error in
// the options is returned by every call of that function.
ColumnReader sqlite_column_reader(const Options& options,
                                  const std::string& data_folder,
                                  const std::string& application_folder);

} // namespace parlour::adapters
