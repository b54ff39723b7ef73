// Prints the results of conversations for people.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "tools/parlour/conversation_test/conversation_result.hpp"

namespace parlour::tools {

// What was said up to the first line that differs, what was expected and found
// there, and the state of the engine. Empty if the conversation passed.
std::string failure_text(const ConversationResult& result);

// Prints each failure, with its trace if `trace`.
void print_failures(std::ostream& out,
                    const std::vector<ConversationResult>& results, bool trace);

// Prints the lines that --update has changed, before and after.
void print_rewordings(std::ostream& out, const ConversationResult& result);

// Prints "2 of 3 conversations passed".
void print_summary(std::ostream& out,
                   const std::vector<ConversationResult>& results);

// Masks private values. What the file itself says may be shown.
void hide_in(ConversationResult& result,
             const std::function<std::string(const std::string&)>& masked);

} // namespace parlour::tools
