#include "runtime/plugin/open_messages.hpp"

namespace parlour {

Message without_its_way(const Message& message) {
  Message kept;
  kept.command = message.command;
  kept.params = message.params;
  kept.session = message.session;
  kept.correlation = message.correlation;
  return kept;
}

bool OpenMessages::open(std::size_t most) {
  const std::lock_guard lock(mutex_);
  if (count_ >= most)
    return false;
  ++count_;
  return true;
}

// Notified under the lock: who waited may destroy this at once.
void OpenMessages::close() {
  const std::lock_guard lock(mutex_);
  --count_;
  closed_.notify_all();
}

void OpenMessages::wait_for_all() {
  std::unique_lock lock(mutex_);
  closed_.wait(lock, [this] { return count_ == 0; });
}

} // namespace parlour
