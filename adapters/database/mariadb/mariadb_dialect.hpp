// What a script's statement may be, and what a MariaDB server is told so that
// it reads SQL as SQLite does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "adapters/database/mariadb/mariadb_options.hpp"
#include "adapters/database/sql_scan.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

enum class StatementKind : std::uint8_t { reads, changes_rows, changes_tables };

// Kinds: Refused for what is not for scripts or not alone, Database where there
// is no statement.
Expected<StatementKind> statement_kind(const std::string& sql,
                                       const ScannedSql& scanned);

// The first of a connection. "…" names a column, || joins texts, a backslash is
// a letter, values that do not fit are errors, texts are compared byte by byte.
std::vector<std::string> dialect_commands(const MariaDBOptions& options);

} // namespace parlour::adapters
