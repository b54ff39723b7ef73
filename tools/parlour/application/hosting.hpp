// Where a component's plug-in runs: the attribute `host` of its <component>.
#pragma once

#include <filesystem>

#include "runtime/base/upkeep.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// The plug-in, or where its upkeep says host="process", the same in a process
// of its own: of this program, or of the one that the environment's
// PARLOUR_PROGRAM names. `file`: where it comes from; empty: the program. One
// of a file is asked in a session's own turn only where its upkeep says so:
// nobody can give it up there when it hangs.
PluginFactory hosted(PluginFactory factory, const Upkeep& upkeep,
                     const std::filesystem::path& file = {});

} // namespace parlour::tools
