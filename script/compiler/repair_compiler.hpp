// <repair>: what is done about the conversation itself, and when nothing was
// understood or said (engine rule 5).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// One repair for each act that the element names. Topics must be compiled.
void compile_repair(const Element& element, bool of_platform,
                    const FunctionNames* functions, Compilation& compilation);

} // namespace parlour::script
