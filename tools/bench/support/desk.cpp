#include "tools/bench/support/desk.hpp"

namespace parlour::tools {

void Desk::take(std::vector<Message>& events) {
  events.clear();
  std::unique_lock lock(mutex_);
  arrived_.wait(lock, [this] { return !events_.empty(); });
  events_.swap(events);
}

void Desk::fire_event(Message event) {
  std::unique_lock lock(mutex_);
  events_.push_back(std::move(event));
  const bool is_first = events_.size() == 1;
  // Unlocking first: the thread that wakes need not wait for this one.
  lock.unlock();
  if (is_first)
    arrived_.notify_one();
}

} // namespace parlour::tools
