#include "adapters/database/mariadb/connection/mariadb_errors.hpp"

namespace parlour::adapters {

namespace {

// The range of the client library's errors (CR_MIN_ERROR, CR_MAX_ERROR).
constexpr unsigned first_of_library = 2000;
constexpr unsigned last_of_library = 2999;

} // namespace

// The first group are errors of the server that close the connection. The
// second are errors of the library about a call; the connection stays usable.
// All other errors of the library are failures of the network.
bool ends_connection(unsigned code) {
  switch (code) {
  case 1040: // too many connections
  case 1053: // the server shuts down
  case 1152: // the server aborted the connection
  case 1158: // network: error or timeout, reading or writing
  case 1159:
  case 1160:
  case 1161:
  case 1184:
  case 1203: // too many connections of this user
  case 1927: // killed
    return true;
  case 2008: // no memory
  case 2030: // the statement is not prepared
  case 2031: // no values were bound
  case 2032: // a cell was truncated
  case 2034: // the number of a placeholder is invalid
  case 2036: // the type cannot be bound
  case 2051: // there is no description of columns
  case mariadb_changed_columns:
    return false;
  default:
    return says_nothing_of_statement(code);
  }
}

bool says_nothing_of_statement(unsigned code) {
  return code >= first_of_library && code <= last_of_library &&
         code != mariadb_changed_columns;
}

bool ends_transaction(unsigned code) {
  return code == 1205 || // lock wait timeout
         code == 1213 || // deadlock
         code == 1020 || // a row that was read has changed
         code == 1180;   // the commit failed
}

ErrorKind mariadb_error_kind(unsigned code) {
  switch (code) {
  case 1205: // lock wait timeout
  case 1969: // max_statement_time
    return ErrorKind::timeout;
  case 1044: // access denied: to the database
  case 1045: // with this password
  case 1142: // to the table
  case 1143: // to the column
  case 1227: // without a privilege
  case 1290: // the server is read-only
  case 1370: // to the routine
  case 1698: // with this way of authentication
  case 1792: // the transaction is read-only
  case 2026: // TLS: certificate or protocol
    return ErrorKind::refused;
  case 1153: // a packet is too large, for the server
  case 2020: // or for the library
    return ErrorKind::limit;
  default:
    return ends_connection(code) ? ErrorKind::offline : ErrorKind::database;
  }
}

} // namespace parlour::adapters
