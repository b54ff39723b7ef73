// Which effects of scripts cannot be taken back, or are heard (language rule
// 12.20): all but those that only look, ask, or are the script's own matter.
#pragma once

#include "script/program/host.hpp"

namespace parlour::dialogue {

bool is_deed(const script::Effect& effect);

} // namespace parlour::dialogue
