#include "adapters/database/sqlite/sqlite_connection.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <sqlite3.h>

#include "adapters/database/sqlite/sqlite_values.hpp"

namespace parlour::adapters {

namespace {

// How many instructions of SQLite's virtual machine run between two calls of
// `progress`. The step limit is exact to this number.
constexpr int steps_per_look = 10'000;
// The longest text or blob, in bytes.
constexpr int longest_cell = 16 << 20;

// Returns a statement to the cache at its start and without bound values. A
// statement that is not reset would keep its read lock.
class Reset {
public:
  explicit Reset(sqlite3_stmt* statement) : statement_(statement) {}
  Reset(const Reset&) = delete;
  Reset& operator=(const Reset&) = delete;
  ~Reset() {
    sqlite3_reset(statement_);
    sqlite3_clear_bindings(statement_);
  }

private:
  sqlite3_stmt* statement_;
};

// Why a script may not take an action of sqlite3_set_authorizer, or null if it
// may. SQLite asks while it prepares a statement, once for each action.
const char* refusal(int action, bool controlling, const char* second) {
  switch (action) {
  case SQLITE_ATTACH:
  case SQLITE_DETACH:
    return "another database cannot be attached";
  case SQLITE_PRAGMA:
    return "PRAGMA is not for scripts";
  case SQLITE_TRANSACTION:
  case SQLITE_SAVEPOINT:
    return controlling ? nullptr : "transactions are begun by <transaction>";
  case SQLITE_FUNCTION:
    return std::string_view(second ? second : "") == "load_extension"
               ? "no library can be loaded"
               : nullptr;
  default:
    return nullptr;
  }
}

// The low byte is the primary result code; the rest is an extension.
ErrorKind kind_of(int code) {
  switch (code & 0xff) {
  case SQLITE_AUTH:
  case SQLITE_READONLY:
    return ErrorKind::refused;
  case SQLITE_INTERRUPT:
  case SQLITE_TOOBIG:
    return ErrorKind::limit;
  case SQLITE_BUSY:
    return ErrorKind::timeout;
  default:
    return ErrorKind::database;
  }
}

Columns columns_of(sqlite3_stmt* statement) {
  const int count = sqlite3_column_count(statement);
  std::vector<std::string> columns;
  columns.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    columns.emplace_back(sqlite3_column_name(statement, i));
  return columns;
}

} // namespace

void CloseSQLite::operator()(sqlite3* handle) const {
  sqlite3_close_v2(handle);
}

void FinalizeStatement::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

SQLiteConnection::SQLiteConnection(SQLiteHandle handle, SQLiteLimits limits,
                                   Milliseconds busy_timeout)
    : handle_(std::move(handle)), limits_(limits) {
  auto* db = handle_.get();
  sqlite3_busy_timeout(db, static_cast<int>(busy_timeout.count()));
  sqlite3_extended_result_codes(db, 1);
  sqlite3_limit(db, SQLITE_LIMIT_LENGTH, longest_cell);
  // A misspelt "column" in double quotes is an error, not a text.
  sqlite3_db_config(db, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
  // No statement can corrupt the file, and functions with side effects cannot
  // be called from the schema of a file that somebody else made.
  sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_set_authorizer(db, &SQLiteConnection::authorize, this);
  sqlite3_progress_handler(db, steps_per_look, &SQLiteConnection::progress,
                           this);
}

SQLiteConnection::~SQLiteConnection() = default;

Expected<StatementAnswer> SQLiteConnection::run(const std::string& sql,
                                                const Value& values,
                                                Access access) {
  steps_left_ = limits_.steps;
  auto known = prepared(sql);
  if (!known)
    return tl::make_unexpected(known.error());
  auto* statement = (*known)->statement.get();
  // SQLite itself knows whether a prepared statement writes.
  if (access == Access::read && !sqlite3_stmt_readonly(statement))
    return only_reads(sql);
  Reset reset(statement);
  if (auto bound = bind_values(statement, values); !bound)
    return fail(bound.error().kind,
                first_words(sql) + ": " + bound.error().message);
  return collect(**known);
}

Expected<std::vector<std::string>>
SQLiteConnection::texts(const std::string& sql, const SQLiteLimits& limits) {
  const auto usual = std::exchange(limits_, limits);
  limits_.statements = usual.statements;
  auto answer = run(sql, {}, Access::read);
  limits_ = usual;
  if (!answer)
    return tl::make_unexpected(answer.error());
  std::vector<std::string> texts;
  for (const auto& cell : answer->rows.cells)
    texts.push_back(cell.text());
  return texts;
}

std::set<std::string> SQLiteConnection::take_written() {
  return std::exchange(written_, {});
}

Expected<void> SQLiteConnection::begin() {
  return control("begin immediate");
}

Expected<void> SQLiteConnection::commit() {
  return control("commit");
}

Expected<void> SQLiteConnection::rollback() {
  return control("rollback");
}

bool SQLiteConnection::in_transaction() const {
  return sqlite3_get_autocommit(handle_.get()) == 0;
}

// Runs a statement of the platform. The step limit is reset, since `progress`
// counts the instructions of a commit, too.
Expected<void> SQLiteConnection::control(const char* sql) {
  controlling_ = true;
  steps_left_ = limits_.steps;
  const auto code = sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr);
  controlling_ = false;
  if (code != SQLITE_OK)
    return failure(sql, code);
  return {};
}

// Finds the statement in the cache or prepares it. It becomes the most recently
// used entry; the least recently used one is dropped if the cache is full.
Expected<SQLiteConnection::Prepared*>
SQLiteConnection::prepared(const std::string& sql) {
  if (auto place = places_.find(sql); place != places_.end()) {
    cache_.splice(cache_.begin(), cache_, place->second);
    return &cache_.front();
  }
  auto statement = prepare(sql);
  if (!statement)
    return tl::make_unexpected(statement.error());
  cache_.push_front({sql, std::move(*statement), {}});
  cache_.front().writes = std::exchange(writes_, {});
  places_.emplace(cache_.front().sql, cache_.begin());
  if (cache_.size() > std::max<std::size_t>(limits_.statements, 1)) {
    places_.erase(cache_.back().sql);
    cache_.pop_back();
  }
  return &cache_.front();
}

Expected<SQLiteStatement> SQLiteConnection::prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  const char* rest = nullptr;
  refused_.clear();
  writes_.clear();
  const auto code = sqlite3_prepare_v3(
      handle_.get(), sql.data(), static_cast<int>(sql.size()),
      SQLITE_PREPARE_PERSISTENT, &statement, &rest);
  SQLiteStatement owned(statement);
  if (code != SQLITE_OK)
    return failure(sql, code);
  if (!statement)
    return no_statement();
  if (auto alone = check_rest(sql, rest); !alone)
    return tl::make_unexpected(alone.error());
  return owned;
}

// Accepts only blanks and comments after the first statement. SQLite prepares
// one statement at a time and leaves the rest, so each remaining piece is
// prepared and must be empty.
Expected<void> SQLiteConnection::check_rest(const std::string& sql,
                                            const char* rest) {
  const auto* end = sql.data() + sql.size();
  while (rest < end) {
    sqlite3_stmt* second = nullptr;
    const char* next = nullptr;
    const auto code = sqlite3_prepare_v2(
        handle_.get(), rest, static_cast<int>(end - rest), &second, &next);
    SQLiteStatement owned(second);
    // SQLite stops reading at a zero byte and does not advance.
    if (code != SQLITE_OK || second || next == rest)
      return not_alone(sql);
    rest = next;
  }
  return {};
}

// Steps through the result and copies its cells. Stops at the first row beyond
// a limit, so that no more than the limit is ever in memory.
Expected<StatementAnswer> SQLiteConnection::collect(Prepared& prepared) {
  auto* statement = prepared.statement.get();
  const auto before = sqlite3_total_changes64(handle_.get());
  StatementAnswer answer;
  auto& cells = answer.rows.cells;
  std::size_t rows = 0;
  std::size_t bytes = 0;
  // The first step comes before the columns are read: it prepares the statement
  // again if the tables have changed, and `select *` may then have other
  // columns.
  auto code = sqlite3_step(statement);
  const auto preparations =
      sqlite3_stmt_status(statement, SQLITE_STMTSTATUS_REPREPARE, 0);
  if (std::exchange(prepared.preparations, preparations) != preparations)
    prepared.columns = columns_of(statement);
  answer.rows.columns = prepared.columns;
  const auto columns = prepared.columns.size();
  if (code == SQLITE_ROW)
    cells.reserve(columns);
  for (; code == SQLITE_ROW; code = sqlite3_step(statement)) {
    bytes += append_row(statement, columns, cells);
    if (++rows > limits_.rows || bytes > limits_.bytes)
      return too_much(prepared.sql, limits_.rows, limits_.bytes);
  }
  if (code != SQLITE_DONE)
    return failure(prepared.sql, code);
  answer.changes = sqlite3_total_changes64(handle_.get()) - before;
  if (answer.changes > 0)
    written_.insert(prepared.writes.begin(), prepared.writes.end());
  return answer;
}

tl::unexpected<Error> SQLiteConnection::failure(const std::string& sql,
                                                int code) {
  std::string reason = sqlite3_errmsg(handle_.get());
  if ((code & 0xff) == SQLITE_AUTH && !refused_.empty())
    reason = refused_;
  else if ((code & 0xff) == SQLITE_INTERRUPT)
    reason = "it takes more than " + std::to_string(limits_.steps) + " steps";
  else if ((code & 0xff) == SQLITE_BUSY)
    reason = "another program holds the database";
  return fail(kind_of(code), first_words(sql) + " failed: " + reason + ".");
}

// Those of triggers and of foreign keys are among them.
int SQLiteConnection::authorize(void* self, int action, const char* first,
                                const char* second, const char*, const char*) {
  auto& connection = *static_cast<SQLiteConnection*>(self);
  if (first && (action == SQLITE_INSERT || action == SQLITE_UPDATE ||
                action == SQLITE_DELETE))
    connection.writes_.emplace_back(first);
  const auto* reason = refusal(action, connection.controlling_, second);
  if (!reason)
    return SQLITE_OK;
  connection.refused_ = reason;
  return SQLITE_DENY;
}

// A result other than 0 interrupts the statement (SQLITE_INTERRUPT).
int SQLiteConnection::progress(void* self) {
  auto& left = static_cast<SQLiteConnection*>(self)->steps_left_;
  left -= std::min<std::uint64_t>(left, steps_per_look);
  return left == 0;
}

} // namespace parlour::adapters
