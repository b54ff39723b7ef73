// What a frame may leave open it must not get wrong: another topic would take
// it (language rule 12.23).
#pragma once

#include <optional>

#include "script/dialogue/acts/acts.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

// Where the act names a topic, or a slot of that topic, that there is not; kind
// Range.
// The first name that is wrong; nothing where all are right, or the act names
// no topic. Its alternatives are not looked at. The error has no place: it is
// the script's, which called <fire>.
std::optional<Error> misnamed(const script::Program& program, const Act& act);

} // namespace parlour::dialogue
