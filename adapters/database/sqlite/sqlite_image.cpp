#include "adapters/database/sqlite/sqlite_image.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

#include <sqlite3.h>

#include "adapters/database/sqlite/sqlite_open.hpp"
#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters {

namespace {

namespace fs = std::filesystem;

struct Source {
  fs::path path;
  std::string text;
};

Expected<Source> read_source(const fs::path& path) {
  if (path.empty())
    return Source{};
  return read_file(path).map([&](std::string&& text) {
    return Source{path, std::move(text)};
  });
}

Expected<std::pair<Source, Source>> read_sources(const fs::path& schema,
                                                 const fs::path& seed) {
  auto first = read_source(schema);
  if (!first)
    return tl::make_unexpected(first.error());
  auto second = read_source(seed);
  if (!second)
    return tl::make_unexpected(second.error());
  return std::pair(std::move(*first), std::move(*second));
}

// Counted from 1.
std::uint32_t line_at(const Source& source, std::size_t offset) {
  const auto first = source.text.begin();
  return static_cast<std::uint32_t>(
      1 + std::count(first, first + static_cast<std::ptrdiff_t>(offset), '\n'));
}

// An error with the line of the file. SQLite's offset counts from the start of
// the statement and is -1 if unknown; the line is then that of the statement's
// first word.
tl::unexpected<Error> failure(sqlite3* db, const Source& source,
                              const char* statement) {
  const auto offset = std::max(sqlite3_error_offset(db), 0);
  const auto* blanks = statement + std::strspn(statement, " \t\r\n");
  const auto* place = std::max(statement + offset, blanks);
  const auto line =
      line_at(source, static_cast<std::size_t>(place - source.text.data()));
  return fail(ErrorKind::database,
              first_words(blanks).append(" failed: ") + sqlite3_errmsg(db) +
                  ".",
              {source.path.string(), line, 0});
}

// Runs the statements of a file one after the other. `next` is set to the rest
// of the text by each preparation; `statement` is null for blanks and comments.
Expected<void> run_all(sqlite3* db, const Source& source) {
  // SQLite would take it for the end of the text.
  if (const auto zero = source.text.find('\0'); zero != std::string::npos)
    return fail(ErrorKind::database,
                "A zero byte stands here; the file must be text in UTF-8.",
                {source.path.string(), line_at(source, zero), 0});
  const auto* next = source.text.c_str();
  while (*next) {
    const auto* start = next;
    sqlite3_stmt* statement = nullptr;
    auto code = sqlite3_prepare_v2(db, start, -1, &statement, &next);
    SQLiteStatement owned(statement);
    while (code == SQLITE_OK || code == SQLITE_ROW)
      code = statement ? sqlite3_step(statement) : SQLITE_DONE;
    if (code != SQLITE_DONE)
      return failure(db, source, start);
  }
  return {};
}

Expected<void> transact(sqlite3* db, const char* order) {
  if (sqlite3_exec(db, order, nullptr, nullptr, nullptr) == SQLITE_OK)
    return {};
  return fail(
      ErrorKind::database,
      std::string("The database cannot be made: ") + sqlite3_errmsg(db) +
          ". Schema and seed run in one transaction: leave out 'begin', "
          "'commit' and 'rollback' there.");
}

// Runs both files in one transaction, which is many times faster than one for
// each statement, and serializes the result.
Expected<SQLiteImage> build(const Source& schema, const Source& seed) {
  auto db = open_memory();
  if (!db)
    return tl::make_unexpected(db.error());
  if (auto begun = transact(db->get(), "begin"); !begun)
    return tl::make_unexpected(begun.error());
  for (const auto* source : {&schema, &seed})
    if (auto done = run_all(db->get(), *source); !done)
      return tl::make_unexpected(done.error());
  if (auto done = transact(db->get(), "commit"); !done)
    return tl::make_unexpected(done.error());
  sqlite3_int64 size = 0;
  std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(
      sqlite3_serialize(db->get(), "main", &size, 0), &sqlite3_free);
  if (!bytes && size > 0)
    return fail(ErrorKind::limit, "There is no memory for the database.");
  return std::make_shared<const std::string>(
      reinterpret_cast<const char*>(bytes.get()),
      static_cast<std::size_t>(size));
}

// The images of the process by the texts of schema and seed. Tests of one run
// use one or two; when there are more than `most`, all are dropped and built
// anew.
class Images {
public:
  Expected<SQLiteImage> of(const Source& schema, const Source& seed) {
    const std::lock_guard lock(mutex_);
    const auto key = std::pair(schema.text, seed.text);
    if (auto found = images_.find(key); found != images_.end())
      return found->second;
    // Building under the lock: whoever asks for the same image waits for it
    // instead of building it a second time.
    auto image = build(schema, seed);
    if (!image)
      return image;
    if (images_.size() >= max_images)
      images_.clear();
    images_.emplace(key, *image);
    return image;
  }

private:
  static constexpr std::size_t max_images = 8;
  std::mutex mutex_;
  std::map<std::pair<std::string, std::string>, SQLiteImage> images_;
};

// Copies all pages with SQLite's backup interface. `file` is only for the
// message.
Expected<void> copy(sqlite3* from, sqlite3* to, const fs::path& file) {
  auto* backup = sqlite3_backup_init(to, "main", from, "main");
  if (backup) {
    sqlite3_backup_step(backup, -1);
    sqlite3_backup_finish(backup);
  }
  if (sqlite3_errcode(to) != SQLITE_OK)
    return fail(ErrorKind::file,
                std::string("The database cannot be written: ") +
                    sqlite3_errmsg(to) + ".",
                {file.string(), 0, 0});
  return {};
}

// Opens the image itself, without a copy, for reading. It must outlive the
// handle. Each access is slower than in an ordinary database in memory, since
// SQLite asks its file system whether the bytes have changed; so the handle is
// only the source of a copy.
Expected<SQLiteHandle> open_bytes(const SQLiteImage& image) {
  auto db = open_memory();
  if (!db || image->empty())
    return db;
  const auto size = static_cast<sqlite3_int64>(image->size());
  // SQLite does not write to a database that is opened read-only.
  auto* bytes =
      reinterpret_cast<unsigned char*>(const_cast<char*>(image->data()));
  if (sqlite3_deserialize(db->get(), "main", bytes, size, size,
                          SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    return fail(ErrorKind::database, "The database cannot be copied.");
  return db;
}

// In the same folder, so that renaming it is atomic.
fs::path temporary_beside(const fs::path& file) {
  unsigned number = 0;
  sqlite3_randomness(sizeof number, &number);
  return file.string() + ".new-" + std::to_string(number);
}

// Removes the journals of a former database of that name first: SQLite would
// apply them to the new file.
Expected<void> move_into_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  for (const auto* ending : {"-wal", "-shm", "-journal"})
    fs::remove(to.string() + ending, error);
  fs::rename(from, to, error);
  if (!error)
    return {};
  fs::remove(from, error);
  return fail(ErrorKind::file, "The new database cannot be put in its place.",
              {to.string(), 0, 0});
}

} // namespace

Expected<SQLiteImage> sqlite_image(const fs::path& schema,
                                   const fs::path& seed) {
  static Images images;
  const auto sources = read_sources(schema, seed);
  if (!sources)
    return tl::make_unexpected(sources.error());
  return images.of(sources->first, sources->second);
}

Expected<std::string> sqlite_sources(const fs::path& schema,
                                     const fs::path& seed) {
  const auto sources = read_sources(schema, seed);
  if (!sources)
    return tl::make_unexpected(sources.error());
  return sources->first.text + '\0' + sources->second.text;
}

Expected<SQLiteHandle> open_image(const SQLiteImage& image) {
  auto from = open_bytes(image);
  if (!from)
    return from;
  auto to = open_memory();
  if (!to || image->empty())
    return to;
  if (auto copied = copy(from->get(), to->get(), {}); !copied)
    return tl::make_unexpected(copied.error());
  return to;
}

Expected<void> write_image(const SQLiteImage& image, const fs::path& file) {
  // If the folder cannot be created, opening the file fails with a clearer
  // message.
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  auto from = open_bytes(image);
  if (!from)
    return tl::make_unexpected(from.error());
  const auto temporary = temporary_beside(file);
  auto to = open_file(temporary, Missing::create);
  if (!to)
    return tl::make_unexpected(to.error());
  auto copied = copy(from->get(), to->get(), file);
  to->reset();
  if (!copied) {
    fs::remove(temporary, ignored);
    return copied;
  }
  return move_into_place(temporary, file);
}

} // namespace parlour::adapters
