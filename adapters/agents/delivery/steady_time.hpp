// The time of heartbeats and acknowledgements, in milliseconds. It never jumps,
// as the time of day does.
#pragma once

#include <chrono>

#include "runtime/base/clock.hpp"

namespace parlour::adapters::agents {

inline Timestamp steady_now() {
  return std::chrono::duration_cast<Milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

} // namespace parlour::adapters::agents
