#include "script/vm/builtin_functions.hpp"

#include <array>

namespace parlour::script {

namespace {

constexpr std::array functions{
#define BUILTIN(name, minimum, maximum, function, sentence) &builtins::function,
#include "script/expression/builtins.def"
#undef BUILTIN
};

} // namespace

BuiltinFunction builtin_function(std::uint16_t index) {
  return functions[index];
}

} // namespace parlour::script
