// Which session variables a topic's filling events may read, of the compiled
// code (Topic::read_variables). The frame is given these and no others.
#pragma once

#include "script/program/program.hpp"

namespace parlour::script {

// When all code is there.
void note_read_variables(Program& program);

} // namespace parlour::script
