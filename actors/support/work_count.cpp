#include "actors/support/work_count.hpp"

namespace parlour::actors {

Work WorkCount::begin() {
  return Work(*this);
}

void WorkCount::all_done() {
  wake();
}

void WorkCount::session_waits(bool waits) {
  waiting_ += waits ? 1 : -1;
  wake();
}

bool WorkCount::wait(const std::function<bool()>& done,
                     std::optional<Deadline> deadline) {
  auto over = [&] { return interrupted_ || done(); };
  std::unique_lock lock(mutex_);
  if (deadline)
    changed_.wait_until(lock, *deadline, over);
  else
    changed_.wait(lock, over);
  return !interrupted_ && done();
}

void WorkCount::wake() {
  // Notified under the lock: a waiter that has looked but not yet gone to
  // sleep must not miss it, and whoever destroys us waits for it.
  std::lock_guard lock(mutex_);
  changed_.notify_all();
}

void WorkCount::interrupt() {
  interrupted_ = true;
  wake();
}

void WorkCount::forget_interrupt() {
  interrupted_ = false;
}

} // namespace parlour::actors
