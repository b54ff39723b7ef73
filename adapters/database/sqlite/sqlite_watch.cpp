#include "adapters/database/sqlite/sqlite_watch.hpp"

#include <optional>
#include <utility>

#include <sqlite3.h>

#include "adapters/database/sqlite/sqlite_open.hpp"

namespace parlour::adapters {

// The number that SQLite counts up for a connection whenever another one has
// committed a change.
class SQLiteWatch::Version {
public:
  static Expected<std::unique_ptr<Version>>
  of(const std::filesystem::path& file) {
    auto handle = open_file(file, Missing::refuse);
    if (!handle)
      return tl::make_unexpected(handle.error());
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(handle->get(), "pragma data_version", -1, &statement,
                           nullptr) != SQLITE_OK)
      return fail(ErrorKind::database, sqlite3_errmsg(handle->get()),
                  {file.string(), 0, 0});
    auto made = std::make_unique<Version>(std::move(*handle),
                                          SQLiteStatement(statement));
    made->has_changed();
    return made;
  }

  Version(SQLiteHandle handle, SQLiteStatement statement)
      : handle_(std::move(handle)), statement_(std::move(statement)) {}

  // Since the last call.
  bool has_changed() {
    const bool is_read = sqlite3_step(statement_.get()) == SQLITE_ROW;
    const auto now =
        is_read ? sqlite3_column_int64(statement_.get(), 0) : last_;
    sqlite3_reset(statement_.get());
    return std::exchange(last_, now) != now;
  }

private:
  SQLiteHandle handle_; // closed last
  SQLiteStatement statement_;
  std::int64_t last_ = 0;
};

Expected<std::unique_ptr<SQLiteWatch>>
SQLiteWatch::start(const std::filesystem::path& file, Milliseconds every,
                   std::function<void()> changed) {
  auto version = Version::of(file);
  if (!version)
    return tl::make_unexpected(version.error());
  auto loop = Loop::start([](const std::string&) {});
  if (!loop)
    return tl::make_unexpected(loop.error());
  return std::unique_ptr<SQLiteWatch>(new SQLiteWatch(
      std::move(*loop), std::move(*version), every, std::move(changed)));
}

SQLiteWatch::SQLiteWatch(std::unique_ptr<Loop> loop,
                         std::unique_ptr<Version> version, Milliseconds every,
                         std::function<void()> changed)
    : loop_(std::move(loop)), version_(std::move(version)), every_(every),
      changed_(std::move(changed)), alarm_(*loop_, [this] { look(); }) {
  loop_->post([this] { look(); });
}

SQLiteWatch::~SQLiteWatch() {
  loop_->stop();
}

void SQLiteWatch::look() {
  alarm_.set(std::chrono::steady_clock::now() + every_);
  if (version_->has_changed())
    changed_();
}

} // namespace parlour::adapters
