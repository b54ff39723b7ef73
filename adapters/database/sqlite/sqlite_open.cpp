#include "adapters/database/sqlite/sqlite_open.hpp"

#include <sqlite3.h>

namespace parlour::adapters {

namespace {

namespace fs = std::filesystem;

// Larger files are not read completely: the check would delay the start. For
// them only the schema is read.
constexpr std::uintmax_t largest_to_check = 64 << 20;

// SQLite returns a handle even for most errors: it holds the message and must
// be closed.
Expected<SQLiteHandle> open(const char* name, int flags) {
  sqlite3* db = nullptr;
  const auto code =
      sqlite3_open_v2(name, &db, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  SQLiteHandle handle(db);
  if (code != SQLITE_OK)
    return fail(ErrorKind::file,
                std::string("The database cannot be opened: ") +
                    (db ? sqlite3_errmsg(db) : sqlite3_errstr(code)) + ".",
                {name, 0, 0});
  return handle;
}

// Callback of sqlite3_exec: keeps the first cell of the first row.
int keep_first(void* into, int count, char** cells, char**) {
  auto& text = *static_cast<std::string*>(into);
  if (text.empty() && count > 0 && cells[0])
    text = cells[0];
  return 0;
}

// Runs a statement and returns the first cell, or SQLite's error message.
tl::expected<std::string, std::string> ask(sqlite3* db, const char* sql) {
  std::string answer;
  if (sqlite3_exec(db, sql, &keep_first, &answer, nullptr) != SQLITE_OK)
    return tl::make_unexpected(std::string(sqlite3_errmsg(db)));
  return answer;
}

tl::unexpected<Error> damaged(const fs::path& file, const std::string& why) {
  return fail(ErrorKind::database,
              "The database file is damaged (" + why +
                  "). Put a sound copy in its place, or move it away to have "
                  "it made anew from schema and seed.",
              {file.string(), 0, 0});
}

} // namespace

Expected<SQLiteHandle> open_memory() {
  return open(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
}

Expected<SQLiteHandle> open_file(const fs::path& file, Missing missing) {
  return open(file.c_str(),
              SQLITE_OPEN_READWRITE |
                  (missing == Missing::create ? SQLITE_OPEN_CREATE : 0));
}

Expected<void> check_sound(const fs::path& file, Milliseconds busy_timeout) {
  auto db = open_file(file, Missing::refuse);
  if (!db)
    return tl::make_unexpected(db.error());
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (error || size == 0)
    return damaged(file, "it is empty");
  sqlite3_busy_timeout(db->get(), static_cast<int>(busy_timeout.count()));
  // quick_check answers "ok" or the first problem. The schema of an intact file
  // can be read, whatever the answer is.
  const auto answer = ask(db->get(), size <= largest_to_check
                                         ? "pragma quick_check(1)"
                                         : "select 'ok' from sqlite_schema");
  if (!answer)
    return damaged(file, answer.error());
  if (*answer != "ok" && size <= largest_to_check)
    return damaged(file, *answer);
  return {};
}

Expected<void> allow_writing(sqlite3* handle, const fs::path& file,
                             Milliseconds busy_timeout) {
  sqlite3_busy_timeout(handle, static_cast<int>(busy_timeout.count()));
  const auto mode = ask(handle, "pragma journal_mode = wal");
  if (!mode || sqlite3_db_readonly(handle, "main") == 1)
    return fail(ErrorKind::file,
                "The database cannot be written: " +
                    (mode ? "the file is read-only" : mode.error()) + ".",
                {file.string(), 0, 0});
  return {};
}

} // namespace parlour::adapters
