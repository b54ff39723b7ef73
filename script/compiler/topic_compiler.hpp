// Compiles topics with their slots (engine rule 5).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// `topic` has the names of its slots already (name_collector).
void compile_topic(const Element& element, Topic& topic,
                   const FunctionNames* functions, Compilation& compilation);

// Reports topics that need each other, directly or through others.
void check_needs(Compilation& compilation);

} // namespace parlour::script
