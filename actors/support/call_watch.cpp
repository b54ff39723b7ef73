#include "actors/support/call_watch.hpp"

#include <utility>

namespace parlour::actors {

void CallWatch::expect(Work work) {
  std::lock_guard lock(mutex_);
  expected_ = std::move(work);
}

CallWatch::Begin CallWatch::begin(Timestamp now, Work& work) {
  std::lock_guard lock(mutex_);
  if (given_up_)
    return Begin::refused;
  since_ = now;
  work_ = std::move(work ? work : expected_);
  return std::exchange(watched_, true) ? Begin::watched : Begin::unwatched;
}

bool CallWatch::end(Work& work) {
  std::lock_guard lock(mutex_);
  since_.reset();
  std::swap(work, work_);
  return !given_up_;
}

bool CallWatch::in_call() const {
  std::lock_guard lock(mutex_);
  return since_.has_value();
}

void CallWatch::watch_anew() {
  std::lock_guard lock(mutex_);
  watched_ = false;
}

std::optional<Milliseconds> CallWatch::look(Timestamp now,
                                            Milliseconds deadline) {
  std::lock_guard lock(mutex_);
  watched_ = since_.has_value();
  if (!since_)
    return std::nullopt;
  return deadline - Milliseconds(now - *since_);
}

bool CallWatch::give_up() {
  Work over; // let go of outside of the lock: it may wake others
  Work expected;
  std::lock_guard lock(mutex_);
  given_up_ = true;
  over = std::move(work_);
  expected = std::move(expected_);
  return since_.has_value();
}

} // namespace parlour::actors
