// The names of effects in scripts, and questions about them, answered by
// effects.def.
#pragma once

#include <cstdint>
#include <string>

#include "script/program/host.hpp"

namespace parlour::script {

// Whether an effect cannot be taken back, or is heard (language rule 12.20).
enum class Deed : std::uint8_t { yes, no, by_statement };

// The name of the element that makes the effect.
std::string element_of(EffectKind kind);

// Whether the effect suspends its script until an answer comes.
bool waits(EffectKind kind);

Deed deed_of(EffectKind kind);

// Whether it chooses another state. Scripts that run on the way to a state (an
// Exit, or the body of a <transit>) may not do that (language rule 12.1).
bool leads_elsewhere(EffectKind kind);

} // namespace parlour::script
