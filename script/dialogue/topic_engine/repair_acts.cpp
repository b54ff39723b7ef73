#include "script/dialogue/topic_engine/repair_acts.hpp"

#include <utility>

namespace parlour::dialogue {

namespace {

// Those that take the place of an answer: they count like an answer that was
// not understood.
bool evades(ActKind kind) {
  return kind == ActKind::protest || kind == ActKind::refuse;
}

// Those that the question which waits has a part in.
bool about_the_question(ActKind kind) {
  return kind == ActKind::help || kind == ActKind::explain ||
         kind == ActKind::options || kind == ActKind::rephrase ||
         kind == ActKind::person || evades(kind);
}

// Who says them leaves the question as it is.
bool leaves_question_open(ActKind kind) {
  return kind == ActKind::repeat || kind == ActKind::wait;
}

} // namespace

// The <repair> sees the slot that is asked for, so "help" explains this slot. A
// refusal or protest counts as a miss, or a user who answers "I won't tell you"
// were asked for ever. Anything but "repeat" and "wait" comes between a
// question and its answer: a yes after it is not taken for the old question.
void RepairActs::generic_act(const steps::TopicAct& step, TopicId topic,
                             TopicId done) {
  const auto kind = step.act->kind;
  Trouble trouble{.act = name_of(kind),
                  .turn = step.turn,
                  .answered = breath_.holds_an_answer()};
  if (about_the_question(kind) && question_ && question_->heard) {
    trouble.topic = question_->topic;
    trouble.slot = question_->slot;
    if (evades(kind))
      trouble.count = reprompts_.count_evasion();
  } else if (kind == ActKind::cancel) {
    trouble.topic = topic == script::no_id ? ends_.to_cancel() : topic;
    if (trouble.topic == script::no_id && !question_)
      trouble.topic = done;
  }
  repairs_.understood();
  if (question_ && !leaves_question_open(kind) && !trouble.answered)
    question_.interrupt(); // unless it is asked again
  if (!repairs_.repair(trouble))
    reprompts_.misunderstood(step.turn, step.act->text);
}

} // namespace parlour::dialogue
