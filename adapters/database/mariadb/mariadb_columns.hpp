// A column's values for the understanding, of a MariaDB database.
#pragma once

#include <string>

#include "runtime/base/understanding.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// As sqlite_column_reader: for the composition root, which has the component's
// settings. Asks the server, waiting for it; where the database is to be a
// copy, or is not made yet, tells what schema and seed would make of it.
ColumnReader mariadb_column_reader(const Options& options,
                                   const std::string& application_folder);

} // namespace parlour::adapters
