// The events of <seat opens="…"> as openings: each is what an <open> for that
// seat would be (engine rule 1.8).
#pragma once

#include "script/compiler/compilation.hpp"

namespace parlour::script {

// `settings`: the root of settings.xml. Whether anything can fire such an event
// is checked where the components are known (tools/parlour/application).
void compile_seats(const Element& settings, Compilation& compilation);

} // namespace parlour::script
