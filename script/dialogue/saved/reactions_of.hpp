// Every reaction of a program, in an order that follows from it: handlers in
// file order, then states.
#pragma once

#include <vector>

#include "script/program/program.hpp"

namespace parlour::dialogue {

std::vector<const script::Reaction*>
reactions_of(const script::Program& program);

} // namespace parlour::dialogue
