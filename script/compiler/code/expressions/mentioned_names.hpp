// The names that the expressions of a piece of script mention, so that a body
// that runs later takes these locals with it (language rule 10.2).
#pragma once

#include <functional>
#include <set>
#include <string>

#include "script/source/source.hpp"

namespace parlour::script {

// Of all attributes of the element and of what is inside of it, whatever a name
// means there. What is not well-formed mentions nothing.
std::set<std::string, std::less<>> mentioned_names(const Element& element);

} // namespace parlour::script
