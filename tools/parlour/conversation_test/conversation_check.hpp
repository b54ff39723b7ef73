// Checks the names in a conversation against the application before the
// conversation runs.
#pragma once

#include <vector>

#include "script/program/program.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

// An error, with its line, for each `expect slot` and `expect state` that names
// a topic, slot or state that does not exist. Pure.
std::vector<script::Finding>
check_conversation(const Conversation& conversation,
                   const script::Program& program);

} // namespace parlour::tools
