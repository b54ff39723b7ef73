// The main function of a component's process: the plug-in's side of
// process_plugin.hpp.
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Serves one instance of the plug-in over the socket, which it takes over,
// until it is told to stop. Returns the exit status. If the other end closes
// the socket, the whole process exits at once, whatever the plug-in is doing.
// On Linux the process is also killed when the thread that started it ends.
int serve_component(int socket, const PluginFactory& plugin);

// Reports why there is no such plug-in. Returns the exit status.
int refuse_component(int socket, const Error& error);

} // namespace parlour::adapters
