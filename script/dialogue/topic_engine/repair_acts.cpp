#include "script/dialogue/topic_engine/repair_acts.hpp"

#include <utility>

namespace parlour::dialogue {

namespace {

// Those that the question which waits has a part in.
bool about_the_question(ActKind kind) {
  return kind == ActKind::help || kind == ActKind::explain ||
         kind == ActKind::options || kind == ActKind::rephrase ||
         kind == ActKind::person;
}

} // namespace

void RepairActs::generic_act(const steps::TopicAct& step, TopicId topic) {
  const auto kind = step.act->kind;
  Trouble trouble{.act = name_of(kind), .turn = step.turn};
  if (about_the_question(kind) && question_ && question_->heard) {
    trouble.topic = question_->topic;
    trouble.slot = question_->slot;
  } else if (kind == ActKind::cancel) {
    trouble.topic = topic == script::no_id ? ends_.to_cancel() : topic;
  }
  repairs_.understood();
  if (question_ && kind != ActKind::repeat && !breath_.holds_an_answer())
    question_.interrupt(); // unless it is asked again
  if (!repairs_.repair(trouble))
    reprompts_.misunderstood(step.turn, step.act->text);
}

} // namespace parlour::dialogue
