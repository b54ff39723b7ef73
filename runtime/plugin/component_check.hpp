// What a component may be called, which roles its plug-in may have, and whose
// place it may take.
#pragma once

#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

// An error of kind Settings where its messages would pass for those of
// somebody else.
Expected<void> check_component(const std::string& name,
                               const PluginDescription& plugin);

// An error of kind Settings where the plug-in lacks a role that the component,
// whose place it is to take, has filled: nobody would, or another.
Expected<void> check_replacement(const std::string& name,
                                 const PluginDescription& before,
                                 const PluginDescription& after);

} // namespace parlour
