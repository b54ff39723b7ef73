// What effects are called in a script.
#pragma once

#include <string>

#include "script/program/host.hpp"

namespace parlour::script {

// The name of the element that makes the effect, as the author wrote it.
std::string element_of(EffectKind kind);

// Whether a script that wants it goes on later only.
bool waits(EffectKind kind);

// Whether it leads to another state: nothing for a script that runs on the way
// to one, an Exit or what stands in a <transit>.
bool leads_elsewhere(EffectKind kind);

} // namespace parlour::script
