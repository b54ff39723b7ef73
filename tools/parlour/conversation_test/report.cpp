// See docs/test.md, "What is printed".
#include "tools/parlour/conversation_test/report.hpp"

#include <algorithm>
#include <ostream>

namespace parlour::tools {

// Line 0 means that the conversation did not begin, so no line is shown.
std::string failure_text(const ConversationResult& result) {
  if (!result.failure)
    return {};
  const auto& failure = *result.failure;
  auto text = result.file;
  if (failure.line > 0)
    text += ':' + std::to_string(failure.line);
  text += ":\n";
  for (const auto& line : result.said)
    text += "    " + line + '\n';
  text += "  expected: " + failure.expected + "\n  found:    " + failure.found +
          '\n';
  if (!result.context.empty())
    text += "  what the engine thought:\n";
  for (const auto& line : result.context)
    text += "    " + line + '\n';
  return text;
}

void print_rewordings(std::ostream& out, const ConversationResult& result) {
  for (const auto& [line, before, after] : result.rewordings)
    out << "UPDATED " << result.file << ':' << line << ":\n  - R: " << before
        << "\n  + R: " << after << '\n';
}

void print_failures(std::ostream& out,
                    const std::vector<ConversationResult>& results,
                    bool trace) {
  for (const auto& result : results) {
    if (!result.failure)
      continue;
    out << "FAILED " << failure_text(result);
    if (trace)
      for (const auto& line : result.trace)
        out << "  | " << line << '\n';
  }
}

void print_summary(std::ostream& out,
                   const std::vector<ConversationResult>& results) {
  const auto passed =
      std::count_if(results.begin(), results.end(),
                    [](const auto& result) { return !result.failure; });
  out << passed << " of " << results.size() << " conversations passed\n";
}

void hide_in(ConversationResult& result,
             const std::function<std::string(const std::string&)>& masked) {
  for (auto* lines : {&result.context, &result.trace})
    for (auto& line : *lines)
      line = masked(line);
  for (auto& line : result.said)
    if (line.starts_with("R: "))
      line = masked(line);
  if (result.failure)
    result.failure->found = masked(result.failure->found);
}

} // namespace parlour::tools
