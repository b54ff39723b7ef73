// What in a conversation file names something that the application does not
// have, before it is held.
#pragma once

#include <vector>

#include "script/program/program.hpp"
#include "script/source/findings.hpp"
#include "tools/parlour/conversation_test/conversation_file.hpp"

namespace parlour::tools {

std::vector<script::Finding>
check_conversation(const Conversation& conversation,
                   const script::Program& program);

} // namespace parlour::tools
