// The functions of builtins.def. Each is defined in the file of script/builtins
// that has its subject.
//
// A new built-in function needs a row in builtins.def and a function of that
// name in script/builtins; the compiler then knows its name and its number of
// arguments.
#pragma once

#include <cstdint>

namespace parlour::script {

struct BuiltinCall;

namespace builtins {

#define BUILTIN(name, minimum, maximum, function, sentence)                    \
  bool function(BuiltinCall& call);
#include "script/expression/builtins.def"
#undef BUILTIN

} // namespace builtins

// Returns false after raising an error.
using BuiltinFunction = bool (*)(BuiltinCall& call);
// The function for the index in an instruction
// (script/expression/builtins.hpp).
BuiltinFunction builtin_function(std::uint16_t index);

} // namespace parlour::script
