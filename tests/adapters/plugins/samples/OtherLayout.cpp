// Built by a compiler whose strings are of another size.
#include "runtime/plugin/export.hpp"

extern "C" const parlour::PluginLibrary parlour_plugin;
const parlour::PluginLibrary parlour_plugin{
    parlour::plugin_interface, {.string = 7}, nullptr};
