#include "actors/support/quiescence_tracker.hpp"

namespace parlour::actors {

InFlight QuiescenceTracker::begin() {
  return InFlight(*this);
}

void QuiescenceTracker::all_done() {
  wake();
}

void QuiescenceTracker::session_waits(bool waits) {
  waiting_ += waits ? 1 : -1;
  wake();
}

// `done` is called with the lock held: it may read counters and due times, and
// must not call wake().
bool QuiescenceTracker::wait(const std::function<bool()>& done,
                             std::optional<Deadline> deadline) {
  auto over = [&] { return interrupted_ || done(); };
  std::unique_lock lock(mutex_);
  if (deadline)
    changed_.wait_until(lock, *deadline, over);
  else
    changed_.wait(lock, over);
  return !interrupted_ && done();
}

void QuiescenceTracker::wake() {
  // Notified under the lock: a waiter that has looked but not yet gone to
  // sleep must not miss it, and whoever destroys us waits for it.
  std::lock_guard lock(mutex_);
  changed_.notify_all();
}

void QuiescenceTracker::interrupt() {
  interrupted_ = true;
  wake();
}

void QuiescenceTracker::forget_interrupt() {
  interrupted_ = false;
}

} // namespace parlour::actors
