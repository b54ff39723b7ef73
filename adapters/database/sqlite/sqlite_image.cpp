#include "adapters/database/sqlite/sqlite_image.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

#include <sqlite3.h>

#include "adapters/database/sqlite/sqlite_open.hpp"
#include "runtime/base/file_bytes.hpp"

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

tl::unexpected<Error> failure(sqlite3* db, const Source& source,
                              const char* statement) {
  // The error's offset counts from the statement's start; -1 where unknown.
  const auto offset = std::max(sqlite3_error_offset(db), 0);
  const auto* first = source.text.data();
  const auto* blanks = statement + std::strspn(statement, " \t\r\n");
  const auto* place = std::max(statement + offset, blanks);
  const auto line = 1 + std::count(first, place, '\n');
  return fail(ErrorKind::database,
              first_words(blanks).append(" failed: ") + sqlite3_errmsg(db) +
                  ".",
              {source.path.string(), static_cast<std::uint32_t>(line), 0});
}

Expected<void> run_all(sqlite3* db, const Source& source) {
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

Expected<SQLiteImage> build(const Source& schema, const Source& seed) {
  auto db = open_memory();
  if (!db)
    return tl::make_unexpected(db.error());
  sqlite3_exec(db->get(), "begin", nullptr, nullptr, nullptr);
  for (const auto* source : {&schema, &seed})
    if (auto done = run_all(db->get(), *source); !done)
      return tl::make_unexpected(done.error());
  sqlite3_exec(db->get(), "commit", nullptr, nullptr, nullptr);
  sqlite3_int64 size = 0;
  std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(
      sqlite3_serialize(db->get(), "main", &size, 0), &sqlite3_free);
  if (!bytes && size > 0)
    return fail(ErrorKind::limit, "There is no memory for the database.");
  return std::make_shared<const std::string>(
      reinterpret_cast<const char*>(bytes.get()),
      static_cast<std::size_t>(size));
}

// Images by the texts that they were made from.
class Images {
public:
  Expected<SQLiteImage> of(const Source& schema, const Source& seed) {
    const std::lock_guard lock(mutex_);
    const auto key = std::pair(schema.text, seed.text);
    if (auto found = images_.find(key); found != images_.end())
      return found->second;
    auto image = build(schema, seed);
    if (!image)
      return image;
    if (images_.size() >= most)
      images_.clear();
    images_.emplace(key, *image);
    return image;
  }

private:
  static constexpr std::size_t most = 8;
  std::mutex mutex_;
  std::map<std::pair<std::string, std::string>, SQLiteImage> images_;
};

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

// The image itself, to be read while it is there. Each look at it asks a file
// system of SQLite's whether the bytes have changed.
Expected<SQLiteHandle> open_bytes(const SQLiteImage& image) {
  auto db = open_memory();
  if (!db || image->empty())
    return db;
  const auto size = static_cast<sqlite3_int64>(image->size());
  // It only reads what it is handed.
  auto* bytes =
      reinterpret_cast<unsigned char*>(const_cast<char*>(image->data()));
  if (sqlite3_deserialize(db->get(), "main", bytes, size, size,
                          SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    return fail(ErrorKind::database, "The database cannot be copied.");
  return db;
}

fs::path temporary_beside(const fs::path& file) {
  unsigned number = 0;
  sqlite3_randomness(sizeof number, &number);
  return file.string() + ".new-" + std::to_string(number);
}

// What a database of the same name left behind would be taken for its own.
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
  std::error_code ignored; // opening says it better
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
