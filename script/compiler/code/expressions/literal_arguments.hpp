// Checks of a built-in's arguments that are literals: the pattern of format(),
// the kind of spoken() and list().
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "script/expression/expression.hpp"

namespace parlour::script {

struct WrongArgument {
  std::size_t index = 0;
  std::string message;
};

// `call` must call a built-in function with an allowed number of arguments.
// Returns the first argument that is wrong.
std::optional<WrongArgument> wrong_argument(const Node& call);

} // namespace parlour::script
