#include "script/dialogue/topic_engine/yes_or_no.hpp"

#include <memory>
#include <utility>

namespace parlour::dialogue {

namespace {

ActPointer no_instead_of(const Act& act) {
  auto no = act;
  no.kind = ActKind::deny;
  return std::make_shared<const Act>(std::move(no));
}

} // namespace

// A yes or no to the question that waits for one. The tests are the lines of
// the table in engine rule 5.8, from top to bottom. A yes too few costs a
// question; a yes too many may call a taxi.
bool YesOrNo::answer_to_question(const ActPointer& act, TurnId turn) {
  if (question_ && question_->purpose == Asked::For::more &&
      act->kind == ActKind::thank) // "Anything else?" "That is all."
    return answer_to_question(no_instead_of(*act), turn);
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

// It may have been ended since the step was made; then nothing is asked.
void YesOrNo::take(const steps::AskConfirm& step) {
  if (const auto* confirm = confirmations_.latest_confirm()) {
    question_.set(*confirm);
    reprompts_.repeat_question(step.turn);
  }
}

// What the same utterance says besides decides whether it is an answer. "Yes,
// cancel" answers nothing: the cancel is the next act, and the question comes
// again unless that has ended it. "Yes. No!" is not understood. What is left
// then is waited for, if somebody still speaks; only then it counts.
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
  outcome_.answer(question_.take(), *act, turn);
}

} // namespace parlour::dialogue
