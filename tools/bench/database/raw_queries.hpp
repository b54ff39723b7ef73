// The same queries without scripts, components or threads, by the databases'
// own libraries: as fast as it goes. Every cell is looked at as a text.
#pragma once

#include <cstddef>

#include "runtime/base/error.hpp"
#include "tools/bench/database/mariadb_server.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// A prepared statement of a database in memory.
Expected<Measured> raw_sqlite(std::size_t count);

// Prepared on each of so many connections, by the interface that does not wait:
// one query on its way on each. The table is there, in the database `bench`.
Expected<Measured> raw_mariadb(const MariaDBServer& server,
                               std::size_t connections, std::size_t count);

} // namespace parlour::tools
