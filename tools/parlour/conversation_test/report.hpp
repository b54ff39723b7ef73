// What a test run says of its conversations, for people.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/parlour/conversation_test/conversation_runner.hpp"

namespace parlour::tools {

// The conversation up to the first line that differs, what was expected there,
// what came, and what the engine thought. Empty for one that passed.
std::string failure_text(const ConversationResult& result);

// Each failure, with its trace where wanted.
void print_failures(std::ostream& out,
                    const std::vector<ConversationResult>& results, bool trace);

// The lines that have other words now.
void print_rewordings(std::ostream& out, const ConversationResult& result);

// "2 of 3 conversations passed".
void print_summary(std::ostream& out,
                   const std::vector<ConversationResult>& results);

} // namespace parlour::tools
