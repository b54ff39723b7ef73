// Listings of compiled code, for work on the compiler and to see what a
// statement costs. Each instruction is shown with its source line and, by its
// sentence in instructions.def, with what it does to which registers.
#pragma once

#include <string>

#include "script/program/program.hpp"

namespace parlour::script {

// One line for each instruction, and a source line where it changes.
std::string listing(const Program& program, const Code& code);

// All bodies, in the order in which they were compiled.
std::string listing(const Program& program);

} // namespace parlour::script
