// Compiles <routes>: relays and filters of the message centre (engine rule 1).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// Conditions and parameters see the message and constants, but nothing of a
// session (language rule 12.12).
void compile_routes(const Element& routes, Compilation& compilation);

} // namespace parlour::script
