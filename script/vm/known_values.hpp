// Finds out which session variables begin with the same value in every session
// (script/program/initial_values.hpp).
#pragma once

#include <functional>

#include "runtime/base/error.hpp"
#include "script/program/host.hpp"
#include "script/program/initial_values.hpp"
#include "script/program/program.hpp"

namespace parlour::script {

// Runs code in an interpreter that nobody else uses.
using Evaluate = std::function<Expected<Value>(CodeId, Host&)>;

// The values of a program's variables that have such; the first call for a
// program computes them.
//
// A value is known if its expression neither reads variables, slots or messages
// nor calls a function of the script, asks the host for nothing, and has no
// error. All others are left to the sessions.
const KnownValues& known_values_of(const Program& program,
                                   const Evaluate& evaluate);

} // namespace parlour::script
