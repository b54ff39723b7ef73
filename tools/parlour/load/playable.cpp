#include "tools/parlour/load/playable.hpp"

#include <utility>

namespace parlour::tools {

namespace {

const char* hindrance(const Step& step) {
  switch (step.kind) {
  case StepKind::wait:
  case StepKind::clock:
    return "it lets time pass";
  case StepKind::event:
    return "a component or agent says something";
  case StepKind::partial:
  case StepKind::barge_in:
  case StepKind::expect_first_sound:
    return "it needs a voice";
  default:
    return step.voice.empty() ? nullptr : "it needs a voice";
  }
}

bool is_answer(const Step& step) {
  return step.kind == StepKind::robot || step.kind == StepKind::robot_pattern;
}

} // namespace

std::optional<std::string> why_unplayable(const Conversation& conversation) {
  for (const auto& step : conversation.steps)
    if (const auto* why = hindrance(step))
      return "line " + std::to_string(step.line) + ": " + why;
  return std::nullopt;
}

Played played(const Conversation& conversation) {
  Played made{&conversation, {{}}};
  const Step* before = nullptr;
  for (const auto& step : conversation.steps) {
    if (is_answer(step))
      made.turns.back().answers.push_back(&step);
    else if (step.kind != StepKind::user)
      ++made.unchecked;
    else if (before && before->kind == StepKind::user)
      made.turns.back().lines.push_back(step.text);
    else
      made.turns.push_back({{step.text}, {}});
    before = &step;
  }
  return made;
}

} // namespace parlour::tools
