// Prints the results of conversations as JUnit XML, which CI servers read.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/parlour/conversation_test/conversation_runner.hpp"

namespace parlour::tools {

// One <testsuite> named after the application, with a <testcase> for each
// conversation.
void print_junit(std::ostream& out, const std::string& application,
                 const std::vector<ConversationResult>& results);

} // namespace parlour::tools
