// What can be told of a built-in's arguments before anything runs, where they
// stand in the script: the pattern of format(), the kind of spoken().
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

// `call` names a built-in function, and has as many arguments as it takes.
std::optional<WrongArgument> wrong_argument(const Node& call);

} // namespace parlour::script
