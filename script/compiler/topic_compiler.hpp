// Topics with their slots (engine rule 5).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// `topic` holds its slots' names already (name_collector).
void compile_topic(const Element& element, Topic& topic,
                   const FunctionNames* functions, Compilation& compilation);

// Topics that need each other, in however many steps, are an error.
void check_needs(Compilation& compilation);

} // namespace parlour::script
