// A plug-in built by a compiler with another size of std::string.
#include "runtime/plugin/export.hpp"

extern "C" const parlour::PluginLibrary parlour_plugin;
const parlour::PluginLibrary parlour_plugin{
    parlour::plugin_interface, {.string = 7}, nullptr};
