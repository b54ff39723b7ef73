// An empty database made from schema and seed, whole or not at all: where that
// ends in the middle, what was made is made anew the next time.
#pragma once

#include "adapters/database/mariadb/mariadb_connection.hpp"

namespace parlour::adapters {

// Connects, and makes the database and its tables where they are missing and
// the options name a schema; of several programs that do so, one. Errors as
// MariaDBConnection::open has them, File and Database for the schema and seed,
// with the file's line.
MariaDBConnection::Outcome open_and_set_up(MariaDBConnection& connection,
                                           const MariaDBOptions& options);

} // namespace parlour::adapters
