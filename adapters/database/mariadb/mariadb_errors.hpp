// What an error number of MariaDB's server or of its library means.
#pragma once

#include "runtime/base/error.hpp"

namespace parlour::adapters {

// The numbers that somebody asks for by name.
inline constexpr unsigned mariadb_unknown_database = 1049;
inline constexpr unsigned mariadb_no_such_table = 1146;
inline constexpr unsigned mariadb_changed_columns = 2057;

// The connection is of no use any more.
bool ends_connection(unsigned code);
// And the server has not said how the statement went: made by the library.
bool says_nothing_of_statement(unsigned code);
// Whether MariaDB has rolled the whole transaction back, or may have: after
// this, what follows would count alone.
bool ends_transaction(unsigned code);

ErrorKind mariadb_error_kind(unsigned code);

} // namespace parlour::adapters
