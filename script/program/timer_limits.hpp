// Limits on a session's timers (language rule 9.6): their number, and the bytes
// of the local variables that they keep.
#pragma once

#include <optional>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::script {

// At once, waits included.
inline constexpr std::size_t max_timers = 1000;

// The bytes of the local variables that a timer's body keeps.
std::size_t remembered(const std::vector<Value>& locals);

// An error of kind Limit if there are too many timers or they keep more than
// `limit` bytes.
std::optional<Error> refuse_timers(std::size_t count, std::size_t bytes,
                                   std::size_t limit);

} // namespace parlour::script
