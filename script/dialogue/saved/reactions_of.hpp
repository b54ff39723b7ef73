// Every reaction of a program, in an order that follows from it: handlers in
// file order, then states. Saved conversations tell a reaction by its place in
// this list; both sides have the same program, so the places agree.
#pragma once

#include <vector>

#include "script/program/program.hpp"

namespace parlour::dialogue {

std::vector<const script::Reaction*>
reactions_of(const script::Program& program);

} // namespace parlour::dialogue
