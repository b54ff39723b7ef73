// Which scopes a plug-in supports: for `parlour check` and for <load>.
#pragma once

#include "runtime/base/component_policy.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour {

// An error of kind Settings says why the plug-in cannot have this scope.
Expected<void> check_scope(const Scope& scope, const PluginDescription& plugin);

} // namespace parlour
