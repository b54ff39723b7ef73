#include "actors/support/thread_gate.hpp"

#include <utility>

namespace parlour::actors {

void ThreadGate::enter(std::function<void()> action) {
  if (!keeps_out()) {
    action();
    return;
  }
  std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(action));
}

void ThreadGate::belongs_here() {
  owner_ = std::this_thread::get_id();
}

bool ThreadGate::drain() {
  std::unique_lock lock(mutex_);
  auto actions = std::exchange(waiting_, {});
  lock.unlock();
  for (auto& action : actions)
    action();
  return !actions.empty();
}

} // namespace parlour::actors
