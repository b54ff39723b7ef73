#include "adapters/database/mariadb/mariadb_connection.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include <errmsg.h>
#include <mysql.h>
#include <sys/socket.h>

#include "adapters/database/mariadb/mariadb_errors.hpp"
#include "adapters/database/sql_scan.hpp"

namespace parlour::adapters {

namespace {

// A cell that exceeds the limit of a result by up to this much still arrives,
// so that the statement fails with kind Limit instead of losing the connection.
constexpr std::size_t packet_beyond_limit = 16 << 20;

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

// An awaitable call of the C library's non-blocking interface. Each blocking
// function f is there a pair: f_start begins it and f_cont continues it. Both
// return 0 when it is done, else the events to wait for. The constructor starts
// the call, so one that finishes at once never suspends the task.
template <class Result, class Continue, class Handle>
class MariaDBConnection::Call final : Pending {
public:
  template <class Start, class... Arguments>
  Call(MariaDBConnection& connection, Start start, Continue next,
       Handle* handle, Arguments... arguments)
      : connection_(connection), proceed_(next), handle_(handle),
        wanted_(start(&result_, handle, arguments...)) {}
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  bool await_ready() const noexcept {
    return wanted_ == 0;
  }
  void await_suspend(std::coroutine_handle<> waiting) {
    connection_.pending_ = this;
    connection_.waiting_ = waiting;
    connection_.wanted_ = wanted_;
  }
  Result await_resume() const {
    return result_;
  }

private:
  int proceed(int ready) override {
    return proceed_(&result_, handle_, ready);
  }

  MariaDBConnection& connection_;
  Continue proceed_;
  Handle* handle_;
  Result result_{};
  int wanted_;
};

template <class Result, class Start, class Continue, class Handle,
          class... Arguments>
MariaDBConnection::Call<Result, Continue, Handle>
MariaDBConnection::finish(Start start, Continue proceed, Handle* handle,
                          Arguments... arguments) {
  return {*this, start, proceed, handle, arguments...};
}

MariaDBConnection::MariaDBConnection(
    std::shared_ptr<const MariaDBOptions> options)
    : options_(std::move(options)), handle_(mysql_init(nullptr)) {
  set_options();
}

// The socket is shut down first, so that closing does not wait for a server
// that owes an answer. mysql_close detaches the statements, and closing them
// afterwards only frees memory.
MariaDBConnection::~MariaDBConnection() {
  if (const auto socket = mysql_get_socket(handle_); socket >= 0)
    shutdown(socket, SHUT_RDWR);
  mysql_close(handle_);
  for (auto& prepared : cache_)
    mysql_stmt_close(prepared.statement);
}

void MariaDBConnection::set_options() {
  const auto& options = *options_;
  mysql_options(handle_, MYSQL_OPT_NONBLOCK, nullptr);
  mysql_options(handle_, MYSQL_SET_CHARSET_NAME, "utf8mb4");
  for (const auto& command : dialect_commands(options))
    mysql_options(handle_, MYSQL_INIT_COMMAND, command.c_str());
  const unsigned off = 0;
  mysql_options(handle_, MYSQL_OPT_LOCAL_INFILE, &off);
  // Without a port, "localhost" means the Unix socket.
  if (options.port != 0) {
    const auto protocol = MYSQL_PROTOCOL_TCP;
    mysql_options(handle_, MYSQL_OPT_PROTOCOL, &protocol);
  }
  const unsigned long packet = options.bytes + packet_beyond_limit;
  mysql_options(handle_, MYSQL_OPT_MAX_ALLOWED_PACKET, &packet);
  if (options.tls == MariaDBOptions::Tls::off)
    return;
  const my_bool yes = 1;
  const my_bool verify = options.tls == MariaDBOptions::Tls::verify;
  mysql_options(handle_, MYSQL_OPT_SSL_ENFORCE, &yes);
  mysql_options(handle_, MYSQL_OPT_SSL_VERIFY_SERVER_CERT, &verify);
  mysql_ssl_set(handle_, or_null(options.tls_key.string()),
                or_null(options.tls_certificate.string()),
                or_null(options.tls_ca.string()), nullptr, nullptr);
}

MariaDBConnection::Outcome MariaDBConnection::open(To to) {
  give_time(options_->connect_timeout);
  const auto& options = *options_;
  const auto* database =
      to == To::database ? options.database.c_str() : nullptr;
  if (!co_await finish<MYSQL*>(mysql_real_connect_start,
                               mysql_real_connect_cont, handle_,
                               or_null(options.host), or_null(options.user),
                               options.password.c_str(), database, options.port,
                               or_null(options.socket),
                               static_cast<unsigned long>(CLIENT_FOUND_ROWS))) {
    lost_ = true;
    co_return failure("", mysql_errno(handle_), mysql_error(handle_));
  }
  co_return StatementAnswer{};
}

// Switches the access mode if necessary, then finds or prepares the statement
// and executes it. An executed statement that fails is removed from the cache.
// If it failed only because the tables have changed since it was prepared, it
// is prepared once more and repeated.
MariaDBConnection::Outcome MariaDBConnection::run(Value sql, Value values,
                                                  Access access) {
  in_doubt_ = false;
  if (access != access_ && !in_transaction_)
    if (auto allowed = co_await allow(access); !allowed)
      co_return tl::make_unexpected(allowed.error());
  for (bool again = false;; again = true) {
    auto* statement = prepared(*sql.if_string());
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
    if (outcome || lost_)
      co_return outcome;
    // A failed statement may be outdated, or may hold a result that was read in
    // part.
    const bool is_old = code_ == mariadb_changed_columns;
    auto forgotten = co_await forget_front();
    if (!forgotten || !is_old || again)
      co_return outcome;
  }
}

// in_doubt_ is true from the moment at which the statement may have been sent
// until the server has answered.
MariaDBConnection::Outcome MariaDBConnection::control(std::string sql) {
  in_doubt_ = true;
  const auto failed =
      co_await finish<int>(mysql_real_query_start, mysql_real_query_cont,
                           handle_, sql.c_str(), sql.size());
  if (failed)
    co_return failure(sql);
  in_doubt_ = false;
  co_return StatementAnswer{
      {}, static_cast<std::int64_t>(mysql_affected_rows(handle_))};
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

Expected<void> MariaDBConnection::check_kind(const Prepared& prepared,
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
  in_doubt_ = false;
  if (!told)
    co_return tl::make_unexpected(told.error());
  access_ = access;
  co_return Expected<void>();
}

// The cached statement, which becomes the most recently used one; null if none.
MariaDBConnection::Prepared*
MariaDBConnection::prepared(const std::string& sql) {
  const auto place = places_.find(sql);
  if (place == places_.end())
    return nullptr;
  cache_.splice(cache_.begin(), cache_, place->second);
  return &cache_.front();
}

Task<Expected<MariaDBConnection::Prepared*>>
MariaDBConnection::prepare(std::string sql) {
  auto scanned = scan_sql(sql);
  auto kind = statement_kind(sql, scanned);
  if (!kind)
    co_return tl::make_unexpected(kind.error());
  while (cache_.size() >= std::max<std::size_t>(options_->statements, 1))
    if (auto forgotten = co_await forget_oldest(); !forgotten)
      co_return tl::make_unexpected(forgotten.error());
  cache_.push_front({std::move(sql),
                     std::move(scanned.names),
                     *kind,
                     mysql_stmt_init(handle_),
                     {},
                     {}});
  auto& front = cache_.front();
  places_.emplace(front.sql, cache_.begin());
  const auto failed = co_await finish<int>(
      mysql_stmt_prepare_start, mysql_stmt_prepare_cont, front.statement,
      scanned.text.data(), scanned.text.size());
  // Values are bound by position, so our scanner and the server must count the
  // same placeholders. What stands behind "/*!" and the number of a later
  // version, for example, is a comment for the server.
  const bool agrees =
      mysql_stmt_param_count(front.statement) == front.names.size();
  if (!failed && agrees)
    co_return &front;
  auto error = failed ? failure(front)
                      : fail(ErrorKind::refused,
                             first_words(front.sql) +
                                 ": MariaDB finds other placeholders in it; "
                                 "write none between '/*!' and '*/'.");
  if (!lost_)
    co_await forget_front();
  co_return error;
}

Task<Expected<void>> MariaDBConnection::forget_front() {
  places_.erase(cache_.front().sql);
  const auto failed = co_await finish<my_bool>(
      mysql_stmt_close_start, mysql_stmt_close_cont, cache_.front().statement);
  cache_.pop_front();
  if (failed)
    co_return failure("");
  co_return Expected<void>();
}

Task<Expected<void>> MariaDBConnection::forget_oldest() {
  cache_.splice(cache_.begin(), cache_, std::prev(cache_.end()));
  co_return co_await forget_front();
}

MariaDBConnection::Outcome MariaDBConnection::execute(Prepared& prepared) {
  if (!prepared.parameters.bind(prepared.statement))
    co_return failure(prepared);
  in_doubt_ = true;
  const auto failed = co_await finish<int>(
      mysql_stmt_execute_start, mysql_stmt_execute_cont, prepared.statement);
  if (prepared.parameters.are_large())
    prepared.parameters = {};
  if (failed)
    co_return failure(prepared);
  in_doubt_ = false;
  if (mysql_stmt_field_count(prepared.statement) > 0)
    co_return co_await collect(prepared);
  co_return StatementAnswer{
      {},
      static_cast<std::int64_t>(mysql_stmt_affected_rows(prepared.statement))};
}

// Fetches row by row, so that no more than the limit is ever in memory. The
// rest of the result is read and discarded by mysql_stmt_free_result.
MariaDBConnection::Outcome MariaDBConnection::collect(Prepared& prepared) {
  if (!prepare_row(prepared.statement, prepared.row))
    co_return failure(prepared);
  auto& row = *prepared.row;
  StatementAnswer answer;
  answer.rows.columns = row.columns();
  answer.rows.cells.reserve(answer.rows.columns.size());
  std::size_t rows = 0;
  std::size_t bytes = 0;
  int fetched = 0;
  while (rows <= options_->rows && bytes <= options_->bytes) {
    fetched = co_await finish<int>(mysql_stmt_fetch_start,
                                   mysql_stmt_fetch_cont, prepared.statement);
    if (fetched != 0 && fetched != MYSQL_DATA_TRUNCATED)
      break;
    ++rows;
    bytes += row.size();
    if (rows <= options_->rows && bytes <= options_->bytes &&
        !row.append_to(answer.rows.cells, prepared.statement))
      co_return failure(prepared);
  }
  if (row.is_large())
    prepared.row.reset();
  if (fetched == 1)
    co_return failure(prepared);
  if (co_await finish<my_bool>(mysql_stmt_free_result_start,
                               mysql_stmt_free_result_cont, prepared.statement))
    co_return failure(prepared);
  if (rows > options_->rows || bytes > options_->bytes)
    co_return too_much(prepared.sql, options_->rows, options_->bytes);
  if (prepared.kind != StatementKind::reads)
    // `insert … returning` gives a row for each row it changes.
    answer.changes = static_cast<std::int64_t>(rows);
  co_return answer;
}

tl::unexpected<Error> MariaDBConnection::failure(std::string_view sql,
                                                 unsigned code,
                                                 const char* reason) {
  constexpr unsigned only_reading = 1792;
  code_ = code;
  in_doubt_ = in_doubt_ && says_nothing_of_statement(code);
  ended_transaction_ = ends_transaction(code);
  lost_ = lost_ || ends_connection(code);
  if (code == only_reading)
    return only_reads(sql);
  // A call that was ended at its deadline reports a lost connection; to the
  // script that is a timeout.
  const bool late = lost_ && std::chrono::steady_clock::now() >= deadline_;
  return fail(late ? ErrorKind::timeout : mariadb_error_kind(code),
              (sql.empty() ? "" : first_words(sql) + " failed: ") + reason +
                  (late ? " (no answer in time)." : "."));
}

tl::unexpected<Error> MariaDBConnection::failure(std::string_view sql) {
  return failure(sql, mysql_errno(handle_), mysql_error(handle_));
}

// Errors while rows arrive are recorded at the connection, not at the
// statement.
tl::unexpected<Error> MariaDBConnection::failure(const Prepared& prepared) {
  if (mysql_stmt_errno(prepared.statement) == 0)
    return failure(prepared.sql);
  return failure(prepared.sql, mysql_stmt_errno(prepared.statement),
                 mysql_stmt_error(prepared.statement));
}

} // namespace parlour::adapters
