// Times, dates and durations in English words (language rule 8.12).
#pragma once

#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/text/decimal.hpp"

namespace parlour::script {

// "10:30" or "10:30:00" as "10:30am"; any other text unchanged.
std::string spoken_time(const std::string& text);

// "2026-11-21" as "Saturday, 21 November". The year is added if it is not the
// present one, and replaces the weekday if the date is more than half a year
// away. Any other text is returned unchanged.
std::string spoken_date(const std::string& text, Timestamp now);

// A number of seconds as "one hour and thirty minutes".
std::string spoken_duration(const Decimal& seconds);

} // namespace parlour::script
