// Short ways to make steps.
#pragma once

#include <utility>

#include "script/dialogue/step.hpp"

namespace parlour::dialogue {

// The same work's next step.
inline Step make_step(StepKind kind, Step like) {
  like.kind = kind;
  return like;
}

inline Step topic_step(StepKind kind, TopicId topic) {
  Step step;
  step.kind = kind;
  step.topic = topic;
  return step;
}

inline Step body_step(CodeId code, TurnId turn) {
  Step step;
  step.code = code;
  step.turn = turn;
  return step;
}

} // namespace parlour::dialogue
