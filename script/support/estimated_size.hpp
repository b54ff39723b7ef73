// The memory that a runtime value takes, for the limits on a session's values
// (language rule 9.6).
#pragma once

#include <cstddef>

#include "runtime/base/value.hpp"

namespace parlour::script {

// In bytes, as if nothing in the value were shared. Visits the whole value.
std::size_t estimated_size(const Value& value);

} // namespace parlour::script
