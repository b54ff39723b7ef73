// Complaint: what is wrong with what devices send.
#pragma once

#include <cstdint>

#include "runtime/base/clock.hpp"

namespace parlour::adapters::mqtt {

enum class Complaint : std::uint8_t {
  announcement, // it cannot be read
  state,        // it is none of the device's states
  size,         // a message is too long
  number,       // there are too many devices
  news,         // they come too fast for conversations
};

// There is one line about each of them in this time.
inline constexpr Milliseconds one_complaint_in{10'000};

} // namespace parlour::adapters::mqtt
