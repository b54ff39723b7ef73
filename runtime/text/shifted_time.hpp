// "An hour later" than the time that a slot has, or "half past" the hour of it:
// as the form `time` of the understanding writes them.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/base/value.hpp"

namespace parlour {

// "15:30", of the minutes since midnight. Beyond a day they wrap.
std::string clock_text(std::int64_t minutes);

// The time "15:30" moved by "+01:00" or "-00:30", or to "past 00:15" or "to
// 00:15" of the hour that is said with it. Unknown if `said` is no such
// difference, if there is no time to move, or if the date would change, too.
Value shifted_time(const Value& time, const Value& said);

} // namespace parlour
