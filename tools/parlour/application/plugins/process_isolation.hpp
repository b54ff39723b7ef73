// Decides where a plug-in's code runs: in this process, or in a child process
// (attribute `host` of <component>).
#pragma once

#include <filesystem>

#include "runtime/base/component_policy.hpp"
#include "runtime/plugin/plugin.hpp"

namespace parlour::tools {

// The plug-in as the policy wants it. With host="process" each instance runs in
// a child process: this program, or the one in the environment variable
// PARLOUR_PROGRAM, as `parlour component`. `file` is the plug-in's file, empty
// for one of the program.
//
// A plug-in from a file is not called in a session's own turn unless its policy
// says so: nobody could give up a call there if it hangs.
PluginFactory hosted(PluginFactory factory, const ComponentPolicy& policy,
                     const std::filesystem::path& file = {});

} // namespace parlour::tools
