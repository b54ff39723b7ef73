// What a frame may leave open it must not get wrong: another topic would take
// it (language rule 12.23).
#pragma once

#include <optional>

#include "script/dialogue/acts/acts.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

// Where the act names a topic, or a slot of that topic, that there is not; kind
// Range.
std::optional<Error> misnamed(const script::Program& program, const Act& act);

} // namespace parlour::dialogue
