#include "actors/support/main_thread_queue.hpp"

#include <cassert>
#include <utility>

namespace parlour::actors {

void MainThreadQueue::post(std::function<void()> action) {
  if (!defers()) {
    action();
    return;
  }
  std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(action));
}

void MainThreadQueue::adopt_thread() {
  owner_ = std::this_thread::get_id();
}

// The actions may post others, which wait for the next call.
bool MainThreadQueue::drain() {
  assert(!defers() && "only the node's own thread runs what waits");
  std::unique_lock lock(mutex_);
  auto actions = std::exchange(waiting_, {});
  lock.unlock();
  for (auto& action : actions)
    action();
  return !actions.empty();
}

} // namespace parlour::actors
