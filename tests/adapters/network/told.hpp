// Told: collects the events of a socket, so that a test can wait for them.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/base/outside/sockets.hpp"

namespace parlour::test {

class Told {
public:
  Sockets::Tell teller() {
    return [this](const SocketEvent& event) {
      std::lock_guard lock(mutex_);
      constexpr const char* kinds[] = {"opened", "failed", "text", "closed"};
      lines_.push_back(kinds[static_cast<std::size_t>(event.kind)] +
                       (event.text.empty() ? "" : ": " + event.text));
      changed_.notify_all();
    };
  }
  // Blocks until there are at least so many lines, and returns all.
  std::vector<std::string> wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return lines_.size() >= count; });
    return lines_;
  }
  std::vector<std::string> now() {
    std::lock_guard lock(mutex_);
    return lines_;
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> lines_;
};

} // namespace parlour::test
