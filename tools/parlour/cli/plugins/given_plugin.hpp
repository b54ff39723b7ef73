// A plug-in and its options as the command line gives them.
#pragma once

#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// A path that ends in .so is opened; any other word is a plug-in's name. The
// error has the kind Settings.
Expected<PluginFactory> given_plugin(const Places& places,
                                     const std::string& plugin);

// "NAME=VALUE" pairs as the plug-in's options; an error for the first mistake.
Expected<Options> given_options(const std::vector<std::string>& given,
                                const PluginDescription& plugin);

} // namespace parlour::tools
