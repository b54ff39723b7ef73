// Checks of a component's name, of its plug-in's roles, and of replacing one
// plug-in by another (engine rule 7.3).
#pragma once

#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

// An error of kind Settings if the messages of the component could be mistaken
// for those of a role or of the platform (engine rule 1.5).
Expected<void> check_component(const std::string& name,
                               const PluginDescription& plugin);

// An error of kind Settings if the new plug-in lacks a role that the component
// fills now. Otherwise the role would be empty, or another component would
// silently take it over.
Expected<void> check_replacement(const std::string& name,
                                 const PluginDescription& before,
                                 const PluginDescription& after);

} // namespace parlour
