#include "adapters/database/mariadb/connection/mariadb_dialect.hpp"

#include <chrono>
#include <map>
#include <optional>

#include "adapters/database/statement.hpp"

namespace parlour::adapters {

namespace {

// The words with which a statement of a script may begin. All others are
// missing on purpose: they administer sessions, transactions, users and files
// of the server. `changes_tables` marks statements that commit implicitly in
// MariaDB.
std::optional<StatementKind> kind_of(const std::string& word) {
  static const std::map<std::string, StatementKind> kinds{
      {"select", StatementKind::reads},
      {"with", StatementKind::reads},
      {"values", StatementKind::reads},
      {"(", StatementKind::reads},
      {"describe", StatementKind::reads},
      {"desc", StatementKind::reads},
      {"explain", StatementKind::reads},
      {"show", StatementKind::reads},
      {"insert", StatementKind::changes_rows},
      {"update", StatementKind::changes_rows},
      {"delete", StatementKind::changes_rows},
      {"replace", StatementKind::changes_rows},
      {"create", StatementKind::changes_tables},
      {"drop", StatementKind::changes_tables},
      {"alter", StatementKind::changes_tables},
      {"truncate", StatementKind::changes_tables},
      {"rename", StatementKind::changes_tables}};
  const auto found = kinds.find(word);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

Expected<StatementKind> statement_kind(const std::string& sql,
                                       const ScannedSql& scanned) {
  if (scanned.first_word.empty())
    return no_statement();
  // SQLite refuses a zero byte, at which it stops reading. So it is refused
  // here, too.
  if (scanned.more || sql.find('\0') != std::string::npos)
    return not_alone(sql);
  if (auto kind = kind_of(scanned.first_word))
    return *kind;
  return fail(ErrorKind::refused,
              first_words(sql) + " failed: '" + scanned.first_word +
                  "' does not begin a statement for scripts; transactions are "
                  "begun by <transaction>.");
}

std::vector<std::string> dialect_commands(const MariaDBOptions& options) {
  // InnoDB counts lock waits in whole seconds.
  const auto lock_wait =
      std::chrono::ceil<std::chrono::seconds>(options.busy_timeout).count();
  const auto run = std::chrono::duration<double>(options.query_timeout).count();
  // The collation is byte order without padding, as SQLite compares.
  // Serializable is the only isolation that SQLite has. sql_select_limit ends a
  // result one row after the limit, which is how `collect` notices that the
  // limit is exceeded.
  return {"set names utf8mb4 collate utf8mb4_nopad_bin",
          "set session transaction isolation level serializable",
          "set sql_mode = 'ANSI_QUOTES,PIPES_AS_CONCAT,NO_BACKSLASH_ESCAPES,"
          "STRICT_ALL_TABLES', innodb_lock_wait_timeout = " +
              std::to_string(lock_wait) +
              ", max_statement_time = " + std::to_string(run) +
              ", sql_select_limit = " + std::to_string(options.rows + 1)};
}

} // namespace parlour::adapters
