// The process of a component: the plug-in's side of process_plugin.hpp.
#pragma once

#include "runtime/plugin/plugin.hpp"

namespace parlour::adapters {

// Serves one instance of the plug-in to whoever holds the other end of the
// socket, which it owns from here on, until that one has had enough. The exit
// status. Ends the whole process, whatever the plug-in is doing, when the other
// end goes; and as far as the system can, when the thread that started us does.
int serve_component(int socket, const PluginFactory& plugin);

// Says instead why there is none.
int refuse_component(int socket, const Error& error);

} // namespace parlour::adapters
