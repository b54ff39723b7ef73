// The source of a new plug-in, by the table of roles.
#pragma once

#include <string>

#include "runtime/base/roles.hpp"

namespace parlour::tools {

// A class that derives from the role's tailored adaptor, or where the role has
// none from RolePlugin, with a handler for each command: it answers what is
// always answered by the role's event with what it was given.
std::string plugin_source(const std::string& name, const Role& role);

// "EchoTTS" is "echo_tts", "DoNLU" "do_nlu", "start_mic" as it is.
std::string snake_case(const std::string& name);

} // namespace parlour::tools
