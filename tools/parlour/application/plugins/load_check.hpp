// Checks the <load> statements of scripts against the plug-ins that exist. A
// <load> that would be refused at run time is an error now. A plug-in that is
// not found is only a warning, because it may be installed where the
// application will run. Names that a script computes are not checked.
#pragma once

#include <vector>

#include "script/compiler/compiler.hpp"
#include "tools/parlour/application/plugins/composition.hpp"

namespace parlour::tools {
// Returns findings for the places in the scripts.

std::vector<script::Finding> check_loads(const script::Compiled& compiled,
                                         const Composition& composition,
                                         Catalogue& plugins);

} // namespace parlour::tools
