// Compiles states and handlers (engine rules 1 and 4).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// `functions`: additional functions that are visible there; may be null.
void compile_handler(const Element& element, Handler& handler,
                     const FunctionNames* functions, Compilation& compilation);
// `state` has its name already (name_collector).
void compile_state(const Element& element, State& state,
                   const FunctionNames* functions, Compilation& compilation);

// Reports everything that would choose another state while one is being left:
// in an Exit, in the body of a <transit>, or in a function that these call
// (language rule 12.1). All bodies must have been compiled.
void check_ways_out(Compilation& compilation);

// The functions of a state or topic, together with those around it which they
// do not hide.
FunctionNames local_functions(const Element& holder,
                              const FunctionNames* around,
                              Compilation& compilation);

} // namespace parlour::script
