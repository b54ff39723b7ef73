// Short ways to make steps.
#pragma once

#include <utility>

#include "script/dialogue/agenda/step.hpp"

namespace parlour::dialogue {

// The same work's next step.
inline Step make_step(StepKind kind, Step&& like) {
  like.kind = kind;
  return std::move(like);
}

// One about the same topic, slot and turn, and nothing else.
inline Step light_step(StepKind kind, const Step& like) {
  Step step;
  step.kind = kind;
  step.topic = like.topic;
  step.slot = like.slot;
  step.turn = like.turn;
  return step;
}

// The utterance is dealt with.
inline Step conclude_step(TurnId turn) {
  Step step;
  step.kind = StepKind::conclude;
  step.turn = turn;
  return step;
}

// A step that tells an outcome.
inline Step outcome_step(WaitId wait, Expected<Value> outcome) {
  Step step;
  step.kind = StepKind::resume_wait;
  step.wait = wait;
  step.matter().data = std::move(outcome);
  return step;
}

// An act of the user, to whoever is first in order.
inline Step act_step(ActPointer act, TurnId turn) {
  Step step;
  step.kind = StepKind::take_act;
  step.act = std::move(act);
  step.turn = turn;
  return step;
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
