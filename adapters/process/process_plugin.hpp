// Runs a plug-in in a process of its own, so that a crash or hang of the
// component does not harm the platform. To everybody else it is the same
// component. The end of its process is a failure of the component
// (PluginHost::failed), which the supervisor deals with as with any other.
#pragma once

#include "adapters/process/component_process.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// A factory for the same plug-in in a process. The program of `order` must call
// serve_component for that plug-in (component_server.hpp).
PluginFactory out_of_process(PluginDescription description, ProcessOrder order);

} // namespace parlour::adapters
