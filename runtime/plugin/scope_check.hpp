// Which scopes a plug-in can have: for `check`, and for who loads it.
#pragma once

#include "runtime/base/upkeep.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour {

// An error of kind Settings says why not.
Expected<void> check_scope(const Scope& scope, const PluginDescription& plugin);

} // namespace parlour
