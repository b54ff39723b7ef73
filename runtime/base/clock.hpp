// Time as a parameter: nobody asks the machine for it but the composition root.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"

namespace parlour {

using Milliseconds = std::chrono::milliseconds;

// Milliseconds since 1970-01-01 UTC.
using Timestamp = std::int64_t;

class Clock {
public:
  virtual ~Clock() = default;
  virtual Timestamp now() const = 0; // safe to call from any thread
};

// The machine's clock.
class SystemClock : public Clock {
public:
  Timestamp now() const override;
};

// "2026-11-21 09:00" or "2026-11-21 09:00:30", local time.
Expected<Timestamp> parse_timestamp(std::string_view text);

// strftime of the local time; "%Y-%m-%d %H:%M" unless told otherwise.
std::string format_timestamp(Timestamp time, const char* pattern);

// "1.5s", "200ms", "2m", "1h" (language rule 10.1).
Expected<Milliseconds> parse_duration(std::string_view text);

} // namespace parlour
