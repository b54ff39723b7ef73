// <routes>: relays and filters of the message centre (engine rule 1).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// Conditions and parameters see the message and constants, nothing of a
// session.
void compile_routes(const Element& routes, Compilation& compilation);

} // namespace parlour::script
