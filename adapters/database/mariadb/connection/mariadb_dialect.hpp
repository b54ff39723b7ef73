// Makes a MariaDB server behave like SQLite as far as scripts can see: which
// statements a script may run, and how the server reads SQL.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/database/mariadb/connection/mariadb_options.hpp"
#include "adapters/database/sql_scan.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

enum class StatementKind : std::uint8_t { reads, changes_rows, changes_tables };

// Classifies a statement by its first word. The error is Refused if the
// statement is not for scripts or another one follows it, and Database if the
// text has no statement.
Expected<StatementKind> statement_kind(const std::string& sql,
                                       const ScannedSql& scanned);

// The SQL that is executed first on every connection. After it, "…" quotes a
// name, the operator || joins texts, a backslash is an ordinary character,
// values that do not fit a column are errors, and texts are compared byte by
// byte.
std::vector<std::string> dialect_commands(const MariaDBOptions& options);

} // namespace parlour::adapters
