// A plug-in in a process of its own: the same component to everybody else. What
// ends or stops its process is a failure of the component (PluginHost::failed),
// never of the platform.
#pragma once

#include "adapters/process/component_process.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// The same plug-in by the same name, to be run by `order`: its program says
// serve_component of that plug-in (component_server.hpp).
PluginFactory out_of_process(PluginDescription description, ProcessOrder order);

} // namespace parlour::adapters
