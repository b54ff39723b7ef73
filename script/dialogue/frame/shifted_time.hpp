// "An hour later" than the time that a slot has: a difference, as the form
// `time` of the understanding writes it.
#pragma once

#include "runtime/base/value.hpp"

namespace parlour::dialogue {

// The time "15:30" moved by "+01:00" or "-00:30". Unknown if `said` is no such
// difference, if there is no time to move, or if the date would change, too.
Value shifted_time(const Value& time, const Value& said);

} // namespace parlour::dialogue
