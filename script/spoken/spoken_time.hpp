// Times, days and durations as English says them (language rule 8.12).
#pragma once

#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/decimal.hpp"

namespace parlour::script {

// "10:30" or "10:30:00" as "10:30am"; as it is where it is no time.
std::string spoken_time(const std::string& text);

// "2026-11-21" as "Saturday, 21 November"; with its year where that is not the
// present one, and so far away without its weekday that nobody would know it.
// As it is where it is no day.
std::string spoken_date(const std::string& text, Timestamp now);

// Seconds as "one hour and thirty minutes".
std::string spoken_duration(const Decimal& seconds);

} // namespace parlour::script
