#include "adapters/database/mariadb/mariadb_errors.hpp"

namespace parlour::adapters {

namespace {

// The library's numbers lie between.
constexpr unsigned first_of_library = 2000;
constexpr unsigned last_of_library = 2999;

} // namespace

bool ends_connection(unsigned code) {
  switch (code) {
  case 1040: // too many connections
  case 1053: // shutdown
  case 1152: // aborted
  case 1158: // network: reading
  case 1159:
  case 1160: // writing
  case 1161:
  case 1184:
  case 1203: // too many connections of this user
  case 1927: // killed
    return true;
  case 2008: // no memory
  case 2030: // no prepared statement
  case 2031: // no values
  case 2032: // a cell was cut
  case 2034: // not a number of a placeholder
  case 2036: // a type that cannot be bound
  case 2051: // nothing to describe
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
  return code == 1205 || // waited for a lock for too long
         code == 1213 || // a deadlock
         code == 1020 || // what was read has changed
         code == 1180;   // could not commit
}

ErrorKind mariadb_error_kind(unsigned code) {
  switch (code) {
  case 1205: // waited for a lock for too long
  case 1969: // ran for too long
    return ErrorKind::timeout;
  case 1044: // no right to the database
  case 1045: // nor to connect
  case 1142: // to the table
  case 1143: // to the column
  case 1227: // to do such a thing
  case 1290: // the server only reads
  case 1370: // to the routine
  case 1698: // to connect in this way
  case 1792: // the transaction only reads
  case 2026: // TLS: who it is, or how it speaks
    return ErrorKind::refused;
  case 1153: // a packet that is too large
  case 2020:
    return ErrorKind::limit;
  default:
    return ends_connection(code) ? ErrorKind::offline : ErrorKind::database;
  }
}

} // namespace parlour::adapters
