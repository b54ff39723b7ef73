// States and handlers (engine rules 1 and 4).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// `functions`: those that are seen there besides the session-wide ones; may be
// null.
void compile_handler(const Element& element, Handler& handler,
                     const FunctionNames* functions, Compilation& compilation);
void compile_state(const Element& element, State& state,
                   const FunctionNames* functions, Compilation& compilation);

// What leads to another state, in an Exit, in a <transit> or in what these
// call, is an error. All bodies must be compiled.
void check_ways_out(Compilation& compilation);

// The functions of a state or topic, with those around it that they do not
// hide.
FunctionNames local_functions(const Element& holder,
                              const FunctionNames* around,
                              Compilation& compilation);

} // namespace parlour::script
