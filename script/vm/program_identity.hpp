// What tells one compiled program from another: a hash of all that a stored
// state refers to, that is of its code, of the names of its variables, topics,
// slots and states, and of the instruction set and built-ins that it was
// compiled for. Where its files lie does not count.
#pragma once

#include <cstdint>

#include "script/program/program.hpp"

namespace parlour::script {

// Computed when first asked for, then kept with the constants; any thread.
std::uint64_t identity_of(const Program& program);

} // namespace parlour::script
