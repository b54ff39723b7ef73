// Which effects of scripts cannot be taken back, or are heard (language rule
// 12.20): all but those that only look, ask, or are the script's own matter.
#pragma once

#include "script/program/host.hpp"

namespace parlour::dialogue {

// A <querydb> is one if its statement changes data: a `select` only looks. A
// topic whose <completed> has done none so far is not done yet (engine rule
// 5.8).
bool is_deed(const script::Effect& effect);

} // namespace parlour::dialogue
