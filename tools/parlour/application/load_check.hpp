// What scripts load, against the plug-ins that there are: a <load> that would
// be refused when it comes to it is a mistake now; a plug-in that is not here
// is warned of, as it may be where the application runs. Computed names are not
// looked at.
#pragma once

#include <vector>

#include "script/compiler/compiler.hpp"
#include "tools/parlour/application/composition.hpp"

namespace parlour::tools {

std::vector<script::Finding> check_loads(const script::Compiled& compiled,
                                         const Composition& composition,
                                         Catalogue& plugins);

} // namespace parlour::tools
