// See conversation_file.hpp for what the fields of a step mean.
#include "tools/parlour/conversation_test/conversation_check.hpp"

#include <algorithm>

#include "runtime/base/text/names.hpp"

namespace parlour::tools {

namespace {

using script::Severity;

// The error for a name that is not among the known ones; otherwise empty.
std::string wrong_name(const std::string& what, const std::string& name,
                       const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end())
    return {};
  return "there is no " + what + " '" + name + "'" +
         script::did_you_mean(name, known);
}

// `text` is the topic of an `expect slot`, `target` its slot.
std::string wrong_slot(const Step& step, const script::Program& program) {
  const auto topic = program.topic(step.text);
  if (topic == script::no_id)
    return wrong_name("topic", step.text, names_of(program.topics));
  return wrong_name("slot of " + step.text, step.target,
                    names_of(program.topics[topic].slots));
}

// Only these two kinds of lines name things of the program.
std::string wrong(const Step& step, const script::Program& program) {
  if (step.kind == StepKind::expect_slot)
    return wrong_slot(step, program);
  if (step.kind == StepKind::expect_state)
    return wrong_name("state", step.text, names_of(program.states));
  return {};
}

} // namespace

std::vector<script::Finding>
check_conversation(const Conversation& conversation,
                   const script::Program& program) {
  std::vector<script::Finding> findings;
  for (const auto& step : conversation.steps)
    if (auto message = wrong(step, program); !message.empty())
      findings.push_back({Severity::error,
                          {conversation.file, step.line, 1},
                          std::move(message)});
  return findings;
}

} // namespace parlour::tools
