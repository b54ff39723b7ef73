// Observer: shows what happens to whoever watches, keeps the log, and counts.
// None of it is given what is private.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "actors/support/node_metrics.hpp"
#include "actors/support/privacy/discretion.hpp"
#include "runtime/message/inspection.hpp"

namespace parlour::actors {

// Called by every actor that does something worth seeing; it masks by
// Discretion before anybody is shown anything. Errors of scripts are counted
// here, too.
// Safe to use from any thread.
class Observer {
public:
  struct Watcher {
    // One call at a time; empty where nobody watches. What it throws is logged.
    std::function<void(const Inspection&)> on_inspection = {};
    // False: it is told of errors, logs and unhandled messages only.
    bool all = true;
    // It is shown what is private, too, and at once.
    bool exact = false;
    // It is shown what these actors take: kinds, or names of their own.
    std::vector<std::string> actors = {};
    // One call at a time; may be empty.
    std::function<void(const std::string&)> on_log = {};
    // Empty where nothing of the program is private: then nothing is masked.
    Discretion::IsHeard is_heard = {};
  };

  // Once `left_behind` is set, nobody is told of anything any more.
  Observer(Watcher watcher, const std::atomic<bool>& left_behind);
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;

  // Where nobody watches, errors, logs and unhandled messages are logged.
  // `seen.turn` and `seen.session` say whom it concerns; both may be empty.
  void inspect(Inspection seen);
  void log(const std::string& line);
  // Whether there is somebody to show more than these to.
  bool watches_all() const {
    return all_.load(std::memory_order_relaxed);
  }
  // Somebody wants to be shown all, or does not any more.
  void watch_all(bool wanted);

  // Whether it is to be given each message on its way, now; lives as long.
  const std::atomic<bool>& follows_messages() const {
    return follows_;
  }
  // Whether it may ever be.
  bool may_follow() const {
    return discretion_.hides() || watcher_.on_inspection;
  }
  void follow(const Message& message, const std::string& way);
  // Whether it is to be shown what this actor takes.
  bool traces(std::string_view kind, std::string_view name) const;

  NodeMetrics& metrics() {
    return metrics_;
  }
  Discretion& discretion() {
    return discretion_;
  }
  const Discretion& discretion() const {
    return discretion_;
  }

private:
  void show(const Inspection& seen);
  void log_instead(const Inspection& seen);
  void write(const std::string& line);

  const Watcher watcher_;
  const std::atomic<bool>& left_behind_;
  Discretion discretion_;
  std::atomic<bool> all_;
  std::atomic<bool> follows_;
  NodeMetrics metrics_;
  std::mutex showing_;
  std::mutex logging_;
};

} // namespace parlour::actors
