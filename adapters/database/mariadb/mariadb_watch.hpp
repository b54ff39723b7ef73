// MariaDBWatch notices that a column has other values than before, whoever
// wrote them. A server tells nobody of changes, so it is asked every so often:
// how many rows there are and the sum of their checksums. Only if that differs,
// the values are read. No index helps the server with the sum, which reads the
// whole table: what a look costs is bounded by the pause after it.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "adapters/database/mariadb/connection/mariadb_connection.hpp"
#include "adapters/database/value_watch.hpp"
#include "adapters/loop/alarm.hpp"
#include "adapters/loop/loop.hpp"

namespace parlour::adapters {

// At least `watch`, and so long that the server spends at most a tenth of its
// time on the looks of one program.
std::chrono::steady_clock::duration
pause_after_look(std::chrono::steady_clock::duration took, Milliseconds watch);

class MariaDBWatch {
public:
  // Watches the columns of the options on a thread of its own, over one
  // connection. `told` is called on that thread, and not during or after the
  // destructor.
  static Expected<std::unique_ptr<MariaDBWatch>>
  start(const MariaDBOptions& options,
        std::function<void(const ValueWatch::News&)> told);
  MariaDBWatch(const MariaDBWatch&) = delete;
  MariaDBWatch& operator=(const MariaDBWatch&) = delete;
  // Waits for a question that is being answered.
  ~MariaDBWatch();

  // Looks now, and returns when `told` has been called if there is something to
  // tell.
  void look_now();

private:
  MariaDBWatch(const MariaDBOptions& options, std::unique_ptr<Loop> loop,
               std::function<void(const ValueWatch::News&)> told);

  // On the loop's thread.
  void look();
  void compare();
  bool is_connected();
  // Nothing: the server does not answer.
  std::optional<std::string> signature();
  Expected<ValueWatch::Values> read(const std::string& column);

  const std::shared_ptr<const MariaDBOptions> options_;
  const std::unique_ptr<Loop> loop_;
  const std::function<void(const ValueWatch::News&)> told_;
  ValueWatch values_;
  std::string last_;
  std::unique_ptr<MariaDBConnection> connection_;
  Alarm alarm_;
};

} // namespace parlour::adapters
