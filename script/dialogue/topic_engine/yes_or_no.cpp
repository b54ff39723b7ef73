#include "script/dialogue/topic_engine/yes_or_no.hpp"

#include <utility>

namespace parlour::dialogue {

// A yes or no to the question that waits for one: a <confirm> of the topic
// that the act names, else the question that was heard last.
bool YesOrNo::answer_to_question(const ActPointer& act, TurnId turn) {
  if (!is_answer(*act))
    return false;
  confirmations_.prefer_named_confirm(context_.program->topic(act->topic));
  if (!question_)
    return ask_confirm_again();
  if (!question_->wants_yes_or_no())
    return false;
  const bool same_turn = turn != 0 && question_->turn == turn;
  if (question_->pending || same_turn) // it was said before the question
    return true;
  if (!question_->heard || question_->interrupted || !question_.asked_here())
    reprompts_.repeat_question(turn);
  else
    read_answer(act, turn);
  return true;
}

// Others came in between: who says yes now may mean them.
bool YesOrNo::ask_confirm_again() {
  if (const auto* confirm = confirmations_.latest_confirm()) {
    auto steps = topic_changes_.back_to(confirm->topic);
    steps.add(steps::AskConfirm{});
    context_.lane.now(std::move(steps));
  }
  return confirmations_.any();
}

void YesOrNo::take(const steps::AskConfirm& step) {
  if (const auto* confirm = confirmations_.latest_confirm()) {
    question_.set(*confirm);
    reprompts_.repeat_question(step.turn);
  }
}

// What the same utterance says besides decides whether it is an answer.
void YesOrNo::read_answer(const ActPointer& act, TurnId turn) {
  const auto reading = beside_.read(*act);
  if (reading.wishes) // it follows, and the question comes again
    return;
  if (reading.contradicts) {
    reprompts_.misunderstood(turn, act->text);
    return;
  }
  beside_.drop_echoes();
  if (breath_.waits_for_more(act, turn))
    return;
  beside_.set_wishes_aside();
  outcome_.answer(question_.take(), act->kind == ActKind::confirm, turn);
}

} // namespace parlour::dialogue
