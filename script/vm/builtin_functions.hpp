// The functions of builtins.def; each in the file of script/builtins that has
// its subject.
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

// False: an error was raised.
using BuiltinFunction = bool (*)(BuiltinCall& call);
// By the index that an instruction holds (script/expression/builtins.hpp).
BuiltinFunction builtin_function(std::uint16_t index);

} // namespace parlour::script
