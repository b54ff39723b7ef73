// Opens the file of a plug-in (a shared library with the symbol of
// runtime/plugin/export.hpp).
#pragma once

#include <filesystem>

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Maps a copy of the file as it is now, so that the file can be replaced while
// its plug-in runs, and both versions run side by side. The copy stays mapped
// until the process ends: objects made by it may outlive everything else.
//
// Errors, of kind Settings: there is no such file, it is no plug-in, it was
// built for another Parlour or by an unlike compiler, or it is named otherwise
// than its plug-in.
Expected<PluginFactory> open_plugin_file(const std::filesystem::path& file);

} // namespace parlour::adapters
