#include "tools/bench/desk.hpp"

namespace parlour::tools {

void Desk::take(std::vector<Message>& events) {
  events.clear();
  std::unique_lock lock(mutex_);
  arrived_.wait(lock, [this] { return !events_.empty(); });
  events_.swap(events);
}

void Desk::fire_event(Message event) {
  const std::lock_guard lock(mutex_);
  events_.push_back(std::move(event));
  if (events_.size() == 1)
    arrived_.notify_one();
}

} // namespace parlour::tools
