// The meaning of error numbers of MariaDB: 1000 and up come from the server,
// 2000 to 2999 from the client library.
#pragma once

#include "runtime/base/error.hpp"

namespace parlour::adapters {

// Numbers that other files compare with. The last one means that the columns of
// a prepared statement have changed.
inline constexpr unsigned mariadb_unknown_database = 1049;
inline constexpr unsigned mariadb_no_such_table = 1146;
inline constexpr unsigned mariadb_changed_columns = 2057;

// Whether the connection is unusable after the error.
bool ends_connection(unsigned code);
// Whether the error was made by the client library, so that the server has not
// said how the statement ended.
bool says_nothing_of_statement(unsigned code);
// Whether the server has rolled back the whole transaction, or may have.
// Statements that follow would run outside of it, so the transaction is ended.
bool ends_transaction(unsigned code);

// The kind that scripts see.
ErrorKind mariadb_error_kind(unsigned code);

} // namespace parlour::adapters
