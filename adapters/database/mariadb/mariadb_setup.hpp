// Creates the database from schema and seed if it is empty. MariaDB cannot undo
// the creation of tables, so a marker table exists while they are made: a
// database with the marker was not finished, and is emptied and made again.
#pragma once

#include "adapters/database/mariadb/connection/mariadb_connection.hpp"

namespace parlour::adapters {

// Connects; if the options name a schema, creates the database and its tables
// where they are missing. Several programs may do so at the same time: an
// advisory lock lets one of them work. Errors are those of
// MariaDBConnection::open, and File and Database, with the line, for schema and
// seed.
MariaDBConnection::Outcome open_and_set_up(MariaDBConnection& connection,
                                           const MariaDBOptions& options);

} // namespace parlour::adapters
