// MainThreadQueue: lets other threads into a node. On the real scheduler it
// stands open; in virtual time everything runs on one thread, and what other
// threads want (a plug-in's own thread that fires an event) waits here for it.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace parlour::actors {

class MainThreadQueue {
public:
  enum class Kind { open, one_thread };

  explicit MainThreadQueue(Kind kind) : kind_(kind) {}

  // Runs `action` now or, from another thread than the node's, in drain().
  void post(std::function<void()> action);
  // Whether what the calling thread wants would wait.
  bool defers() const {
    return kind_ != Kind::open && owner_.load() != std::this_thread::get_id();
  }
  // The calling thread is the node's from now on.
  // A node may be driven by one thread after the other.
  void adopt_thread();
  // Runs what waited; false if nothing did.
  bool drain();

private:
  const Kind kind_;
  std::atomic<std::thread::id> owner_ = std::this_thread::get_id();
  std::mutex mutex_;
  std::vector<std::function<void()>> waiting_;
};

} // namespace parlour::actors
