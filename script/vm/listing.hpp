// Listings of compiled code, for whoever works on the compiler or wonders what
// a statement costs: each instruction with its line and, from the table of
// instructions, what it does to which register.
#pragma once

#include <string>

#include "script/program/program.hpp"

namespace parlour::script {

// One line an instruction, the source's lines in between where it is another.
std::string listing(const Program& program, const Code& code);

// Of all bodies, in the order in which they were compiled.
std::string listing(const Program& program);

} // namespace parlour::script
