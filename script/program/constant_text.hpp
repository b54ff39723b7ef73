// Recognises code that only returns a constant, as most questions do, so that
// its text can be used without running the interpreter.
#pragma once

#include <optional>
#include <string_view>

#include "script/program/program.hpp"

namespace parlour::script {

// The constant that the code returns; null if it does anything else.
const Box* constant_of(const Code& code);

// The text of such code, which lives as long as the program; nothing if the
// code must be run.
std::optional<std::string_view> constant_text(const Program& program,
                                              CodeId code);

} // namespace parlour::script
