// The steps of creating a database, each a coroutine on the same connection:
//
//  lock -> make_database -> fill_if_empty -> unlock
//                            |
//                            drop_all, if a former attempt was interrupted
//                            fill: marker, schema, seed, marker off
#include "adapters/database/mariadb/mariadb_setup.hpp"

#include <utility>

#include "adapters/database/sql_scan.hpp"
#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters {

namespace {

using Outcome = MariaDBConnection::Outcome;

// The marker table. Its name has blanks, which no table of a schema is likely
// to.
const std::string mark_of_loading = "parlour is loading";
// How long creating the database may take, waiting for the lock included.
constexpr Milliseconds max_time{120'000};

// Runs the statements of a file; the error names its line.
Outcome run_file(MariaDBConnection& connection, std::filesystem::path path) {
  if (path.empty())
    co_return StatementAnswer{};
  const auto text = read_file(path);
  if (!text)
    co_return tl::make_unexpected(text.error());
  for (const auto& part : split_sql(*text)) {
    auto done = co_await connection.control(std::string(part.text));
    if (!done)
      co_return fail(done.error().kind, done.error().message,
                     {path.string(), part.line, 0});
  }
  co_return StatementAnswer{};
}

// Drops the tables and views of a database that was not finished, without
// regard to foreign keys. The marker is dropped by fill() as its last step.
Outcome drop_all(MariaDBConnection& connection) {
  const Value mark = List{mark_of_loading};
  auto drops = co_await connection.run(
      "select concat('drop ', if(table_type = 'VIEW', 'view', 'table'), ' \"', "
      "table_name, '\"') from information_schema.tables "
      "where table_schema = database() and table_name <> ?",
      mark, Access::write);
  if (!drops)
    co_return drops;
  if (auto off = co_await connection.control("set foreign_key_checks = 0");
      !off)
    co_return off;
  for (const auto& drop : drops->rows.cells)
    if (auto dropped = co_await connection.control(drop.text()); !dropped)
      co_return dropped;
  co_return co_await connection.control("set foreign_key_checks = 1");
}

// Creates the tables, then fills them in one transaction, which is many times
// faster than one for each statement.
Outcome fill(MariaDBConnection& connection, const MariaDBOptions& options) {
  auto marked = co_await connection.control("create table if not exists \"" +
                                            mark_of_loading + "\" (a integer)");
  if (!marked)
    co_return marked;
  if (auto done = co_await run_file(connection, options.schema); !done)
    co_return done;
  if (auto begun = co_await connection.control("start transaction"); !begun)
    co_return begun;
  if (auto done = co_await run_file(connection, options.seed); !done)
    co_return done;
  if (auto kept = co_await connection.control("commit"); !kept)
    co_return kept;
  co_return co_await connection.control("drop table \"" + mark_of_loading +
                                        "\"");
}

// Fills a database without tables or with the marker; leaves all others
// unchanged.
Outcome fill_if_empty(MariaDBConnection& connection,
                      const MariaDBOptions& options) {
  const Value mark = List{mark_of_loading};
  auto found = co_await connection.run(
      "select count(*), coalesce(sum(table_name = ?), 0) "
      "from information_schema.tables where table_schema = database()",
      mark, Access::write);
  if (!found)
    co_return found;
  const bool unfinished = found->rows.cells[1] == Value(1);
  if (found->rows.cells[0] != Value(0) && !unfinished)
    co_return StatementAnswer{};
  if (unfinished)
    if (auto dropped = co_await drop_all(connection); !dropped)
      co_return dropped;
  co_return co_await fill(connection, options);
}

// Creates the database if it does not exist, and selects it. Looking first lets
// an account without the right to create databases use one that exists.
Outcome make_database(MariaDBConnection& connection,
                      const std::string& database) {
  const Value values = List{database};
  auto found = co_await connection.run(
      "select count(*) from information_schema.schemata where schema_name = ?",
      values, Access::write);
  if (!found)
    co_return found;
  if (found->rows.cells[0] == Value(0)) {
    auto made = co_await connection.control(
        "create database if not exists \"" + database +
        "\" character set utf8mb4 collate utf8mb4_nopad_bin");
    if (!made)
      co_return made;
  }
  co_return co_await connection.control("use \"" + database + "\"");
}

// Takes a named lock on the server, which is also released when the connection
// ends. Statements of the set-up may run longer than those of scripts.
Outcome lock(MariaDBConnection& connection, const std::string& name) {
  if (auto done = co_await connection.control("set max_statement_time = 0");
      !done)
    co_return done;
  const Value values = List{name};
  auto got =
      co_await connection.run("select get_lock(?, 60)", values, Access::write);
  if (got && got->rows.cells[0] != Value(1))
    co_return fail(ErrorKind::timeout,
                   "Another program has been making the database for a "
                   "minute.");
  co_return got;
}

Outcome set_up(MariaDBConnection& connection, const MariaDBOptions& options) {
  const auto name = "parlour " + options.database;
  if (auto locked = co_await lock(connection, name); !locked)
    co_return locked;
  if (auto made = co_await make_database(connection, options.database); !made)
    co_return made;
  if (auto filled = co_await fill_if_empty(connection, options); !filled)
    co_return filled;
  co_return co_await connection.control("do release_lock('" + name + "')");
}

} // namespace

MariaDBConnection::Outcome open_and_set_up(MariaDBConnection& connection,
                                           const MariaDBOptions& options) {
  using To = MariaDBConnection::To;
  if (options.schema.empty())
    co_return co_await connection.open(To::database);
  if (auto opened = co_await connection.open(To::server); !opened)
    co_return opened;
  connection.give_time(max_time);
  if (auto done = co_await set_up(connection, options); !done)
    co_return done;
  // From here on the limit of the options holds for statements again.
  const auto seconds =
      std::chrono::duration<double>(options.query_timeout).count();
  co_return co_await connection.control("set max_statement_time = " +
                                        std::to_string(seconds));
}

} // namespace parlour::adapters
