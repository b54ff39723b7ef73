// The peers of query_workload.hpp: the same queries through the databases' own
// libraries, without scripts, components or threads. Each cell is read as a
// text.
#pragma once

#include <cstddef>

#include "runtime/base/error.hpp"
#include "tools/bench/database/mariadb_server.hpp"
#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// Uses a prepared statement on a database in memory.
Expected<Measured> raw_sqlite(std::size_t count);

// Uses a prepared statement on each connection, and the library's non-blocking
// interface: one query is under way on each connection. The table must exist in
// the database `bench`.
Expected<Measured> raw_mariadb(const MariaDBServer& server,
                               std::size_t connections, std::size_t count);

} // namespace parlour::tools
