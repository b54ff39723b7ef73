// Calls into a plug-in that runs alone, without a node: what it throws becomes
// an error. A node catches it, too.
#pragma once

#include <functional>
#include <memory>

#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// An error of kind Refused if the action throws.
Expected<void> call_plugin(const std::function<void()>& action);

// Makes a plug-in and starts it. The host outlives it.
Expected<std::unique_ptr<IPlugin>> start_plugin(const PluginFactory& factory,
                                                PluginHost& host,
                                                const Options& options);

Expected<void> send_to_plugin(IPlugin& plugin, const Message& message);

// Nobody wants to know any more what it throws.
void stop_plugin(IPlugin& plugin);

} // namespace parlour::tools
