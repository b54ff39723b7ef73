// What <seat>s say of components, checked where the plug-ins are known (engine
// rule 7.7).
#pragma once

#include "tools/parlour/application/plugins/composition.hpp"

namespace parlour::tools {

// Remote agents that a seat names become its own, and what belongs to a seat
// comes before the others: at its seat it is preferred, and elsewhere it is not
// there. A component that does not fill its role is reported in `findings`.
void bind_to_seats(const Settings& settings, Composition& composition);

} // namespace parlour::tools
