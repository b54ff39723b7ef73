// What is wrong with a plug-in's description of itself.
#pragma once

#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

// A sentence each: without a name, a sentence or a known role; an option that
// is described twice, without a sentence, or by a default that does not fit its
// type.
std::vector<std::string> check_description(const PluginDescription& plugin);

} // namespace parlour
