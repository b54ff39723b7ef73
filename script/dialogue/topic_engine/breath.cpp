#include "script/dialogue/topic_engine/breath.hpp"

#include <utility>

namespace parlour::dialogue {

namespace {

// Whoever listens has seen it before.
steps::TopicAct answer_step(const Unsettled& answer, TurnId turn) {
  return {answer.act, turn};
}

} // namespace

// Turns that have begun end by themselves (engine rule 3.1): it never waits for
// ever.
bool Breath::waits_for_more(const ActPointer& act, TurnId turn) {
  if (!context_.turns.any_open(context_.now, turn))
    return false;
  unsettled_ = {act, turn, question_->output, question_->wait};
  return true;
}

// An act of a further turn: the yes or no before it is read together with it.
// "Yes" … "but at three" becomes "yes, but at three". The answer takes the
// later turn. With its own, it would wait again, for the very words that have
// come.
bool Breath::joins(steps::TakeAct& step) {
  if (!unsettled_ || unsettled_->turn == step.turn)
    return false;
  const auto answer = *std::exchange(unsettled_, {});
  if (!still_asked(answer))
    return false;
  context_.lane.now({answer_step(answer, step.turn), std::move(step)});
  return true;
}

// The utterance of the answer has concluded long since, while its question
// still stood. A further Conclude asks for what is due now.
bool Breath::nothing_followed() {
  if (!unsettled_ || !context_.lane.idle() ||
      context_.turns.any_open(context_.now, unsettled_->turn))
    return false;
  const auto answer = *std::exchange(unsettled_, {});
  if (!still_asked(answer))
    return false;
  context_.lane.queue(
      {answer_step(answer, answer.turn), steps::Conclude{answer.turn}});
  return true;
}

bool Breath::still_asked(const Unsettled& answer) const {
  return question_ && question_->output == answer.question &&
         question_->wait == answer.wait;
}

} // namespace parlour::dialogue
