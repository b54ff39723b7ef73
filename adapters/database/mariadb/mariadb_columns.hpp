// Reads the distinct values of one column of a MariaDB database, as
// sqlite_columns.hpp does for SQLite.
#pragma once

#include <string>
#include <vector>

#include "adapters/database/column_reference.hpp"
#include "runtime/message/understanding.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

class MariaDBConnection; // connection/mariadb_connection.hpp
struct MariaDBOptions;   // connection/mariadb_options.hpp

// Options of a connection that reads columns: one may be larger than the result
// of a query.
MariaDBOptions with_room_for_a_column(MariaDBOptions options);

// The distinct values in ascending order, without NULL. Blocks for at most the
// time that the connection was given.
Expected<std::vector<std::string>> read_column(MariaDBConnection& connection,
                                               const ColumnReference& place);

// Returns a function that reads a column such as "db:robot.name". Each call
// opens a connection of its own and waits for the server. If the database does
// not exist yet, or the component has a copy of its own (option `copy`), the
// values are those that schema and seed would create. Thread-safe. An error in
// the options is returned by every call of the function.
ColumnReader mariadb_column_reader(const Options& options,
                                   const std::string& application_folder);

} // namespace parlour::adapters
