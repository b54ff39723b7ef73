// Normal forms of the typed cardinalities (understanding, "Normal forms"):
// time `10:30`, date `2026-11-21`, duration in seconds, level an integer,
// phone digits with an optional `+`. Simple written forms ("10:30am", "B1")
// are converted; words are the understanding's business. Pure.
#pragma once

#include <string_view>

#include "runtime/base/value.hpp"

namespace parlour::dialogue {

// `type`: a cardinality's.
bool has_normal_form(std::string_view type);

// Unknown where the value is none of that type, and where the type has no
// normal form. A value in normal form stays as it is.
Value normal_form(std::string_view type, const Value& value);

} // namespace parlour::dialogue
