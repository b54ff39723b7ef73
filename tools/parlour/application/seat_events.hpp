// The events that are to open a conversation at a seat: <seat opens="…">,
// checked where the components and their events are known (engine rule 1.8).
#pragma once

#include <vector>

#include "script/program/program.hpp"
#include "tools/parlour/application/plugins/composition.hpp"

namespace parlour::tools {

// An error for an event that nothing can fire, a warning for one whose role
// nobody fills.
std::vector<script::Finding> check_seat_events(const script::Program& program,
                                               const Composition& composition);

} // namespace parlour::tools
