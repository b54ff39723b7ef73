// SQLiteWatch notices that somebody has changed a database file: another
// program, or another connection of this one.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "adapters/loop/alarm.hpp"
#include "adapters/loop/loop.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

class SQLiteWatch {
public:
  // Looks at the file every so often, over a connection and on a thread of its
  // own. `changed` is called on that thread, and not during or after the
  // destructor. While another program holds the file, nothing is noticed.
  static Expected<std::unique_ptr<SQLiteWatch>>
  start(const std::filesystem::path& file, Milliseconds every,
        std::function<void()> changed);
  SQLiteWatch(const SQLiteWatch&) = delete;
  SQLiteWatch& operator=(const SQLiteWatch&) = delete;
  ~SQLiteWatch();

private:
  class Version;
  SQLiteWatch(std::unique_ptr<Loop> loop, std::unique_ptr<Version> version,
              Milliseconds every, std::function<void()> changed);

  void look();

  const std::unique_ptr<Loop> loop_;
  // Used on the loop's thread.
  const std::unique_ptr<Version> version_;
  const Milliseconds every_;
  const std::function<void()> changed_;
  Alarm alarm_;
};

} // namespace parlour::adapters
