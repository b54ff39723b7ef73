// Completes the description of a plug-in whose roles, commands and events are
// data: those of an HTTPService are in its file of rules.
#pragma once

#include <filesystem>

#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// Does nothing to other plug-ins, nor if the file cannot be read, which
// resource_check.hpp reports.
void complete_description(PluginDescription& plugin, const Options& options,
                          const std::filesystem::path& application_folder);

} // namespace parlour::tools
