// Generates the C++ source of a new plug-in from the table of roles.
#pragma once

#include <string>

#include "runtime/message/roles.hpp"

namespace parlour::tools {

// A class for the role, with an `on_x` handler for each command. It derives
// from the role's own adaptor in runtime/plugin/adaptors.hpp (such as
// TTSPlugin), or from RolePlugin if there is none. A command that must be
// answered fires the role's answer at once, with the command's own parameters
// where their names agree. The source ends with PARLOUR_PLUGIN
// (runtime/plugin/export.hpp).
std::string plugin_source(const std::string& name, const Role& role);

// "EchoTTS" becomes "echo_tts", "DoNLU" "do_nlu"; "start_mic" stays.
std::string snake_case(const std::string& name);

} // namespace parlour::tools
