// Results of conversations in JUnit's XML, as CI servers read it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/parlour/conversation_test/conversation_runner.hpp"

namespace parlour::tools {

void print_junit(std::ostream& out, const std::string& application,
                 const std::vector<ConversationResult>& results);

} // namespace parlour::tools
