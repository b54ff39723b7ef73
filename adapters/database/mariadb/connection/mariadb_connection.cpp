#include "adapters/database/mariadb/connection/mariadb_connection.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <mysql.h>
#include <poll.h>

#include "adapters/database/mariadb/connection/mariadb_errors.hpp"
#include "adapters/database/sql_scan.hpp"
#include "adapters/loop/wait_until_ready.hpp"

namespace parlour::adapters {

namespace {

// Provides buffers for the rows of an executed statement; reuses those of the
// last execution if the columns are the same. False if there is no description.
bool prepare_row(MYSQL_STMT* statement, std::unique_ptr<MariaDBRow>& row) {
  const std::unique_ptr<MYSQL_RES, decltype(&mysql_free_result)> description(
      mysql_stmt_result_metadata(statement), &mysql_free_result);
  if (!description)
    return false;
  if (row && row->fits(description.get()))
    return true;
  row = std::make_unique<MariaDBRow>(description.get());
  return row->bind(statement);
}

const char* or_null(const std::string& text) {
  return text.empty() ? nullptr : text.c_str();
}

} // namespace

MariaDBConnection::MariaDBConnection(
    std::shared_ptr<const MariaDBOptions> options)
    : options_(std::move(options)), handle_(*options_) {}

short MariaDBConnection::interest() const {
  // Only the end of the connection can be received without a task.
  return calls_.is_waiting() ? calls_.interest() : POLLIN;
}

MariaDBConnection::Outcome MariaDBConnection::open(To to) {
  give_time(options_->connect_timeout);
  const auto& options = *options_;
  const auto* database =
      to == To::database ? options.database.c_str() : nullptr;
  if (!co_await calls_.make<MYSQL*>(
          mysql_real_connect_start, mysql_real_connect_cont, handle_.get(),
          or_null(options.host), or_null(options.user),
          options.password.c_str(), database, options.port,
          or_null(options.socket),
          static_cast<unsigned long>(CLIENT_FOUND_ROWS))) {
    state_.lose();
    co_return failure("");
  }
  co_return StatementAnswer{};
}

// Switches the access mode if necessary, then finds or prepares the statement
// and executes it. An executed statement that fails is removed from the cache.
// If it failed only because the tables have changed since it was prepared, it
// is prepared once more and repeated.
MariaDBConnection::Outcome MariaDBConnection::run(Value sql, Value values,
                                                  Access access) {
  state_.answered();
  if (access != access_ && !in_transaction_)
    if (auto allowed = co_await allow(access); !allowed)
      co_return tl::make_unexpected(allowed.error());
  for (bool again = false;; again = true) {
    auto* statement = cache_.find(*sql.if_string());
    if (!statement) {
      auto made = co_await prepare(*sql.if_string());
      if (!made)
        co_return tl::make_unexpected(made.error());
      statement = *made;
    }
    if (auto fits = check_kind(*statement, access); !fits)
      co_return tl::make_unexpected(fits.error());
    if (auto fits = statement->parameters.take(values, statement->names); !fits)
      co_return fail(fits.error().kind,
                     first_words(statement->sql) + ": " + fits.error().message);
    auto outcome = co_await execute(*statement);
    if (outcome || state_.lost())
      co_return outcome;
    // A failed statement may be outdated, or may hold a result that was read in
    // part.
    const bool is_old = state_.code() == mariadb_changed_columns;
    auto forgotten = co_await forget(*statement);
    if (!forgotten || !is_old || again)
      co_return outcome;
  }
}

// In doubt from the moment at which the statement may have been sent until the
// server has answered.
MariaDBConnection::Outcome MariaDBConnection::control(std::string sql) {
  state_.sent();
  const auto failed =
      co_await calls_.make<int>(mysql_real_query_start, mysql_real_query_cont,
                                handle_.get(), sql.c_str(), sql.size());
  if (failed)
    co_return failure(sql);
  state_.answered();
  co_return StatementAnswer{
      {}, static_cast<std::int64_t>(mysql_affected_rows(handle_.get()))};
}

MariaDBConnection::Outcome MariaDBConnection::begin() {
  auto begun = co_await control("start transaction read write");
  in_transaction_ = begun.has_value();
  co_return begun;
}

MariaDBConnection::Outcome MariaDBConnection::end(End how) {
  auto ended = co_await control(how == End::commit ? "commit" : "rollback");
  in_transaction_ = false;
  co_return ended;
}

Expected<void> MariaDBConnection::check_kind(const PreparedStatement& prepared,
                                             Access access) const {
  if (access == Access::read && prepared.kind != StatementKind::reads)
    return only_reads(prepared.sql);
  if (in_transaction_ && prepared.kind == StatementKind::changes_tables)
    return fail(ErrorKind::refused,
                first_words(prepared.sql) +
                    ": MariaDB cannot undo it, so that it cannot stand in a "
                    "<transaction>.");
  return {};
}

// The server itself refuses to write on a connection that only reads, so the
// first word of a statement is not the only protection. Switching is no
// statement of the script, so it is never in doubt.
Task<Expected<void>> MariaDBConnection::allow(Access access) {
  auto told = co_await control(access == Access::read
                                   ? "set session transaction read only"
                                   : "set session transaction read write");
  state_.answered();
  if (!told)
    co_return tl::make_unexpected(told.error());
  access_ = access;
  co_return Expected<void>();
}

Task<Expected<PreparedStatement*>> MariaDBConnection::prepare(std::string sql) {
  auto scanned = scan_sql(sql);
  auto kind = statement_kind(sql, scanned);
  if (!kind)
    co_return tl::make_unexpected(kind.error());
  while (cache_.size() >= std::max<std::size_t>(options_->statements, 1))
    if (auto forgotten = co_await forget(cache_.oldest()); !forgotten)
      co_return tl::make_unexpected(forgotten.error());
  auto& made = cache_.add(
      {std::move(sql), std::move(scanned.names), *kind,
       decltype(PreparedStatement::statement)(mysql_stmt_init(handle_.get()))});
  const auto failed = co_await calls_.make<int>(
      mysql_stmt_prepare_start, mysql_stmt_prepare_cont, made.statement.get(),
      scanned.text.data(), scanned.text.size());
  // Values are bound by position, so our scanner and the server must count the
  // same placeholders. What stands behind "/*!" and the number of a later
  // version, for example, is a comment for the server.
  const bool agrees =
      mysql_stmt_param_count(made.statement.get()) == made.names.size();
  if (!failed && agrees)
    co_return &made;
  auto error = failed ? failure(made)
                      : fail(ErrorKind::refused,
                             first_words(made.sql) +
                                 ": MariaDB finds other placeholders in it; "
                                 "write none between '/*!' and '*/'.");
  if (!state_.lost())
    co_await forget(made);
  co_return error;
}

Task<Expected<void>> MariaDBConnection::forget(PreparedStatement& prepared) {
  const auto failed = co_await calls_.make<my_bool>(
      mysql_stmt_close_start, mysql_stmt_close_cont, prepared.statement.get());
  cache_.forget(prepared);
  if (failed)
    co_return failure("");
  co_return Expected<void>();
}

MariaDBConnection::Outcome
MariaDBConnection::execute(PreparedStatement& prepared) {
  if (!prepared.parameters.bind(prepared.statement.get()))
    co_return failure(prepared);
  state_.sent();
  const auto failed = co_await calls_.make<int>(mysql_stmt_execute_start,
                                                mysql_stmt_execute_cont,
                                                prepared.statement.get());
  if (prepared.parameters.are_large())
    prepared.parameters = {};
  if (failed)
    co_return failure(prepared);
  state_.answered();
  if (mysql_stmt_field_count(prepared.statement.get()) > 0)
    co_return co_await collect(prepared);
  co_return StatementAnswer{{},
                            static_cast<std::int64_t>(mysql_stmt_affected_rows(
                                prepared.statement.get()))};
}

// Fetches row by row, so that no more than the limit is ever in memory. The
// rest of the result is read and discarded by mysql_stmt_free_result.
MariaDBConnection::Outcome
MariaDBConnection::collect(PreparedStatement& prepared) {
  if (!prepare_row(prepared.statement.get(), prepared.row))
    co_return failure(prepared);
  auto& row = *prepared.row;
  StatementAnswer answer;
  answer.rows.columns = row.columns();
  answer.rows.cells.reserve(answer.rows.columns.size());
  std::size_t rows = 0;
  std::size_t bytes = 0;
  int fetched = 0;
  while (rows <= options_->rows && bytes <= options_->bytes) {
    fetched =
        co_await calls_.make<int>(mysql_stmt_fetch_start, mysql_stmt_fetch_cont,
                                  prepared.statement.get());
    if (fetched != 0 && fetched != MYSQL_DATA_TRUNCATED)
      break;
    ++rows;
    bytes += row.size();
    if (rows <= options_->rows && bytes <= options_->bytes &&
        !row.append_to(answer.rows.cells, prepared.statement.get()))
      co_return failure(prepared);
  }
  if (row.is_large())
    prepared.row.reset();
  if (fetched == 1)
    co_return failure(prepared);
  if (co_await calls_.make<my_bool>(mysql_stmt_free_result_start,
                                    mysql_stmt_free_result_cont,
                                    prepared.statement.get()))
    co_return failure(prepared);
  if (rows > options_->rows || bytes > options_->bytes)
    co_return too_much(prepared.sql, options_->rows, options_->bytes);
  if (prepared.kind != StatementKind::reads)
    // `insert … returning` gives a row for each row it changes.
    answer.changes = static_cast<std::int64_t>(rows);
  co_return answer;
}

tl::unexpected<Error> MariaDBConnection::failure(std::string_view sql) {
  return state_.failed(sql, mysql_errno(handle_.get()),
                       mysql_error(handle_.get()), calls_.is_late());
}

// Errors while rows arrive are recorded at the connection, not at the
// statement.
tl::unexpected<Error>
MariaDBConnection::failure(const PreparedStatement& prepared) {
  auto* const statement = prepared.statement.get();
  if (mysql_stmt_errno(statement) == 0)
    return failure(prepared.sql);
  return state_.failed(prepared.sql, mysql_stmt_errno(statement),
                       mysql_stmt_error(statement), calls_.is_late());
}

StatementOutcome carry_out(MariaDBConnection& connection,
                           MariaDBConnection::Outcome task) {
  for (task.start(); !task.done();) {
    pollfd awaited[] = {{connection.descriptor(), connection.interest(), 0}};
    wait_until_ready(awaited, connection.deadline());
    connection.go_on(awaited[0].revents);
  }
  return task.result();
}

} // namespace parlour::adapters
