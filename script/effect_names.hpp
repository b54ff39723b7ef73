// What effects are called in a script.
#pragma once

#include <string>

#include "script/host.hpp"

namespace parlour::script {

// The name of the element that makes the effect, as the author wrote it.
std::string element_of(EffectKind kind);

} // namespace parlour::script
