#include "tools/parlour/talk/hearing.hpp"

namespace parlour::tools {

void Hearing::take(const Message& message, Moment now) {
  std::lock_guard lock(mutex_);
  last_ = now;
  if (message.command == "FileEnded" && microphones_.contains(message.source))
    file_ended_ = true;
  changed_.notify_all();
}

void Hearing::end() {
  std::lock_guard lock(mutex_);
  interrupted_ = true;
  changed_.notify_all();
}

bool Hearing::is_over(Moment now) const {
  std::lock_guard lock(mutex_);
  return is_over_now(now);
}

void Hearing::wait() {
  std::unique_lock lock(mutex_);
  while (!is_over_now(std::chrono::steady_clock::now()))
    if (file_ended_)
      changed_.wait_until(lock, last_ + quiet_);
    else
      changed_.wait(lock);
}

bool Hearing::is_over_now(Moment now) const {
  return interrupted_ || (file_ended_ && now >= last_ + quiet_);
}

} // namespace parlour::tools
