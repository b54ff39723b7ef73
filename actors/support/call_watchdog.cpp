#include "actors/support/call_watchdog.hpp"

#include <cassert>
#include <utility>

namespace parlour::actors {

void CallWatchdog::expect(InFlight work) {
  std::lock_guard lock(mutex_);
  expected_ = std::move(work);
}

// The calls that start and stop a plug-in bring no token: theirs was left by
// expect().
CallWatchdog::Begin CallWatchdog::begin(Timestamp now, InFlight& work) {
  std::lock_guard lock(mutex_);
  if (given_up_)
    return Begin::refused;
  assert(!since_ && "an instance is in one call at a time");
  since_ = now;
  work_ = std::move(work ? work : expected_);
  return std::exchange(watched_, true) ? Begin::watched : Begin::unwatched;
}

bool CallWatchdog::end(InFlight& work) {
  std::lock_guard lock(mutex_);
  since_.reset();
  std::swap(work, work_);
  return !given_up_;
}

std::optional<Timestamp> CallWatchdog::call_since() const {
  std::lock_guard lock(mutex_);
  return since_;
}

void CallWatchdog::watch_anew() {
  std::lock_guard lock(mutex_);
  watched_ = false;
}

// In one step under the lock: a call that begins a moment later finds that
// nobody watches, and says so.
std::optional<Milliseconds> CallWatchdog::time_left(Timestamp now,
                                                    Milliseconds deadline) {
  std::lock_guard lock(mutex_);
  watched_ = since_.has_value();
  if (!since_)
    return std::nullopt;
  return deadline - Milliseconds(now - *since_);
}

bool CallWatchdog::give_up() {
  InFlight over; // let go of outside of the lock: it may wake others
  InFlight expected;
  std::lock_guard lock(mutex_);
  given_up_ = true;
  over = std::move(work_);
  expected = std::move(expected_);
  return since_.has_value();
}

} // namespace parlour::actors
