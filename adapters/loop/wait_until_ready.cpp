#include "adapters/loop/wait_until_ready.hpp"

#include <algorithm>
#include <cerrno>

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;

// The argument of poll(): rounded up, at most a minute, -1 for no deadline.
int milliseconds_until(Steady::time_point deadline) {
  if (deadline == Steady::time_point::max())
    return -1;
  const auto left =
      std::chrono::ceil<std::chrono::milliseconds>(deadline - Steady::now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 60'000));
}

} // namespace

Waited wait_until_ready(std::span<pollfd> awaited,
                        Steady::time_point deadline) {
  for (;;) {
    const auto patience = milliseconds_until(deadline);
    const auto count = poll(awaited.data(), awaited.size(), patience);
    if (count > 0)
      return Waited::ready;
    if (count < 0 && errno != EINTR)
      return Waited::failed;
    if (count == 0 && patience == 0)
      return Waited::late;
  }
}

} // namespace parlour::adapters
