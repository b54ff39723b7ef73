// For threads that may block: waits for descriptors without a loop.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>

#include <poll.h>

namespace parlour::adapters {

enum class Waited : std::uint8_t {
  // At least one descriptor is ready; `revents` says which.
  ready,
  // The deadline has passed, and none is ready.
  late,
  // The system cannot wait (poll() failed); to wait again would be no better.
  failed
};

// Blocks until a descriptor is ready or the deadline has passed; max() means no
// deadline. A deadline in the past only looks. Errors and hang-ups count as
// ready. A signal does not end the waiting. Entries with the descriptor -1 are
// never ready. Thread-safe.
Waited wait_until_ready(std::span<pollfd> awaited,
                        std::chrono::steady_clock::time_point deadline =
                            std::chrono::steady_clock::time_point::max());

} // namespace parlour::adapters
