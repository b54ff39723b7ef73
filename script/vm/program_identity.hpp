// The identity of a compiled program: a hash of everything that a stored state
// refers to, which is its code, the names of its variables, topics, slots and
// states, and the instruction set and built-ins for which it was compiled. The
// location of its files does not count.
//
// Two compilations of the same files with the same version of the program have
// the same identity; any change of a script, or of the instruction set, gives
// another one, and stored states are then refused.
#pragma once

#include <cstdint>

#include "script/program/program.hpp"

namespace parlour::script {

// Computed when first asked for and kept with the constants. Safe from any
// thread.
std::uint64_t identity_of(const Program& program);

} // namespace parlour::script
