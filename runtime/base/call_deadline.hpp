// How long one call into a component may take.
#pragma once

#include "runtime/base/clock.hpp"
#include "runtime/base/upkeep.hpp"

namespace parlour {

// What its upkeep says; where that is the default, half of the time that a
// request waits at most: who waits is to hear of a component that hangs, and to
// have as long again for another.
Milliseconds call_deadline(const Upkeep& upkeep, Milliseconds request_timeout);

} // namespace parlour
