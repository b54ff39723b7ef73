// Compiles <repair>: reactions to acts about the conversation itself, and to
// silence or words that were not understood (engine rule 5.10).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// Makes one Repair for each act that the element names. Topics must have been
// compiled.
void compile_repair(const Element& element, bool of_platform,
                    const FunctionNames* functions, Compilation& compilation);

} // namespace parlour::script
