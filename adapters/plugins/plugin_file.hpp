// Loads a plug-in from a shared library that exports the symbol of
// runtime/plugin/export.hpp.
#pragma once

#include <filesystem>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Loads a copy of the file. So the file can be replaced while its plug-in runs,
// and two versions can run side by side. The copy stays loaded until the
// process ends, since objects of its code may outlive everything else.
//
// The error has the kind Settings: the file does not exist, is no plug-in, was
// built for another version of Parlour or by an incompatible compiler, or its
// name is not that of the plug-in.
Expected<PluginFactory> open_plugin_file(const std::filesystem::path& file);

} // namespace parlour::adapters
