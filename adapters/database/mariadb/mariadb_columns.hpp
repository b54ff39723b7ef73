// Reads the distinct values of one column of a MariaDB database, as
// sqlite_columns.hpp does for SQLite.
#pragma once

#include <string>

#include "runtime/message/understanding.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Returns a function that reads a column such as "db:robot.name". Each call
// opens a connection of its own and waits for the server. If the database does
// not exist yet, or the component has a copy of its own (option `copy`), the
// values are those that schema and seed would create. Thread-safe. An error in
// the options is returned by every call of the function.
ColumnReader mariadb_column_reader(const Options& options,
                                   const std::string& application_folder);

} // namespace parlour::adapters
