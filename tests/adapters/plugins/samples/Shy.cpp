// A plug-in that throws when it is asked to describe itself.
#include <stdexcept>

#include "runtime/plugin/export.hpp"

extern "C" const parlour::PluginLibrary parlour_plugin;
const parlour::PluginLibrary parlour_plugin{
    parlour::plugin_interface, {}, []() -> parlour::PluginFactory {
      throw std::runtime_error("not today");
    }};
