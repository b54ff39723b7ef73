// Time as a parameter (architecture rule 2). Only the composition root
// asks the machine for the time; everything else is given a Clock.
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

// What time it is. Owned by the composition root; outlives its readers.
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

// Reads "2026-11-21 09:00" or "2026-11-21 09:00:30" as local time. Errors are
// of kind Settings.
Expected<Timestamp> parse_timestamp(std::string_view text);

// Formats the local time by a strftime pattern, such as "%Y-%m-%d %H:%M".
std::string format_timestamp(Timestamp time, const char* pattern);

// Reads a duration such as "1.5s", "200ms", "2m" or "1h" (language rule 10.1).
// Errors are of kind Settings.
Expected<Milliseconds> parse_duration(std::string_view text);

} // namespace parlour
