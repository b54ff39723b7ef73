// The memory that a value of the runtime takes, where it stands in an object of
// a session (language rule 9.6).
#pragma once

#include <cstddef>

#include "runtime/base/value.hpp"

namespace parlour::script {

// In bytes, as if nothing of it were shared.
std::size_t footprint(const Value& value);

} // namespace parlour::script
