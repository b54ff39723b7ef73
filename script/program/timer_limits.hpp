// What a session's timers may take: so many at once, and as many bytes of
// remembered locals as the session's values may hold.
#pragma once

#include <optional>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::script {

inline constexpr std::size_t most_timers = 1000;

// Bytes of the locals that a timer's body remembers.
std::size_t remembered(const std::vector<Value>& locals);

// Why there cannot be so many timers that remember so much, if so.
std::optional<Error> refuse_timers(std::size_t count, std::size_t bytes,
                                   std::size_t limit);

} // namespace parlour::script
