// The text of code that consists of nothing else, as most questions do: nothing
// need be run for it.
#pragma once

#include <optional>
#include <string_view>

#include "script/program/program.hpp"

namespace parlour::script {

// What code that gives a constant gives; null for any other.
const Box* constant_of(const Code& code);

// The text lives as long as the program; nothing where it must be worked out.
std::optional<std::string_view> constant_text(const Program& program,
                                              CodeId code);

} // namespace parlour::script
