// Checks of a plug-in's description of itself.
#pragma once

#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

// One sentence per fault: a missing name, sentence or known role (unless it has
// commands of its own); an option that is described twice or without a
// sentence; a default that does not fit its option's type.
std::vector<std::string> check_description(const PluginDescription& plugin);

} // namespace parlour
