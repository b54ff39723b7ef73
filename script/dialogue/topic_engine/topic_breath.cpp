// The part of the topic engine for a yes or no that more may follow in the same
// breath: it is not acted on before that has been heard, and both are read as
// one utterance (engine rule 5.8, language rule 12.20).
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

namespace {

Step answer_step(const Unsettled& answer, TurnId turn) {
  auto step = act_step(answer.act, turn);
  step.kind = StepKind::topic_act; // whoever listens has seen it before
  return step;
}

} // namespace

// Turns that have begun end by themselves (engine rule 3.1): it never waits for
// ever.
bool TopicEngine::waits_for_more(const Step& step) {
  if (!context_.turns.any_open(context_.now, step.turn))
    return false;
  unsettled_ = {step.act, step.turn, asked_->output, asked_->wait};
  return true;
}

// An act of a further turn: the yes or no before it is read together with it.
bool TopicEngine::joins(Step& step) {
  if (!unsettled_ || unsettled_->turn == step.turn)
    return false;
  const auto answer = *std::exchange(unsettled_, {});
  if (!still_asked(answer))
    return false;
  StepList steps;
  steps.push_back(answer_step(answer, step.turn));
  steps.push_back(std::move(step));
  context_.lane.now(std::move(steps));
  return true;
}

bool TopicEngine::still_asked(const Unsettled& answer) const {
  return asked_ && asked_->output == answer.question &&
         asked_->wait == answer.wait;
}

bool TopicEngine::nothing_followed() {
  if (!unsettled_ || !context_.lane.idle() ||
      context_.turns.any_open(context_.now, unsettled_->turn))
    return false;
  const auto answer = *std::exchange(unsettled_, {});
  if (!still_asked(answer))
    return false;
  context_.lane.queue(
      {answer_step(answer, answer.turn), conclude_step(answer.turn)});
  return true;
}

} // namespace parlour::dialogue
