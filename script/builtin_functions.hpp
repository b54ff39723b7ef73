// The functions of builtins.def; each in the builtins_*.cpp of its subject.
#pragma once

namespace parlour::script {

struct BuiltinCall;

namespace builtins {

#define BUILTIN(name, minimum, maximum, function, sentence)                    \
  bool function(BuiltinCall& call);
#include "script/builtins.def"
#undef BUILTIN

} // namespace builtins

} // namespace parlour::script
