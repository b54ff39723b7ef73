#include "tools/parlour/conversation_test/expectation.hpp"

#include <algorithm>

#include <re2/re2.h>

namespace parlour::tools {

bool is_as_expected(const Value& expected, const Value& found) {
  if (expected.is_unknown() || found.is_unknown())
    return expected.is_unknown() && found.is_unknown();
  return expected == found || to_string(expected) == to_string(found);
}

bool is_as_expected(const Step& step, const Message& post,
                    const ModuleNames& names) {
  if (post.command != step.command || post.params.size() < step.params.size())
    return false;
  for (std::size_t i = 0; i < step.params.size(); ++i)
    if (!is_wildcard(step.params[i]) &&
        !is_as_expected(step.params[i], post.params[i]))
      return false;
  return std::ranges::any_of(post.sinks, [&](const auto& sink) {
    return names.same(sink, step.target);
  });
}

bool is_as_expected(const Step& step, const std::string& said) {
  return step.kind == StepKind::robot ? said == step.text
                                      : RE2::FullMatch(said, RE2(step.text));
}

std::string as_lines(const std::vector<std::string>& outputs) {
  std::string lines;
  for (const auto& output : outputs)
    lines += (lines.empty() ? "" : "\n") + output;
  return lines;
}

std::vector<std::string> outputs_for(std::span<const Step> lines,
                                     const std::deque<std::string>& outputs) {
  const auto other =
      std::ranges::find_if_not(lines.subspan(1), [](const Step& step) {
        return step.kind == StepKind::robot ||
               step.kind == StepKind::robot_pattern;
      });
  const auto following = static_cast<std::size_t>(other - lines.begin()) - 1;
  auto taken = outputs.size() - std::min(following, outputs.size() - 1);
  while (taken > 1) {
    const auto end = outputs.begin() + static_cast<std::ptrdiff_t>(taken);
    const std::vector all(outputs.begin(), end);
    if (lines[0].kind == StepKind::robot_pattern &&
        is_as_expected(lines[0], as_lines(all)))
      return all;
    --taken;
  }
  return {outputs.front()};
}

Message sql_question(const std::string& query) {
  Message question;
  question.source = "Session";
  question.command = "Query";
  question.params = {query, List{}};
  question.sinks = {"Database"};
  return question;
}

Value cells_of(const ResultSet& rows) {
  if (rows.cells.size() == 1)
    return rows.cells[0];
  return rows.cells.empty() ? Value() : Value(rows.cells);
}

} // namespace parlour::tools
