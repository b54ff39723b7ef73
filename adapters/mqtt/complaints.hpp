// Complaints counts what is wrong with what devices send, and says when a line
// about it is due: whoever sends rubbish must not fill the log.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "runtime/base/clock.hpp"

namespace parlour::adapters::mqtt {

enum class Complaint : std::uint8_t {
  announcement, // it cannot be read
  state,        // it is none of the device's states
  size,         // a message is too long
  number,       // there are too many devices
  news,         // they come too fast for conversations
};

// Each kind is limited by itself: a device that floods does not hide that
// another announces itself wrongly.
// Not thread-safe.
class Complaints {
public:
  // Of each kind there is one line in this time.
  static constexpr Milliseconds one_line_in{10'000};

  // Counts it, and returns the line to log, if one is due. It says how many
  // there were without a line.
  std::optional<std::string> note(Complaint kind, const std::string& text,
                                  std::chrono::steady_clock::time_point now);
  std::uint64_t count(Complaint kind) const;

private:
  struct Kind {
    std::uint64_t count = 0;
    // How many there were at the last line, and when that was.
    std::uint64_t written = 0;
    std::chrono::steady_clock::time_point at = {};
  };

  std::array<Kind, 5> kinds_;
};

} // namespace parlour::adapters::mqtt
