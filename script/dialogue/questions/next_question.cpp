#include "script/dialogue/questions/next_question.hpp"

namespace parlour::dialogue {

void NextQuestion::take(const steps::Conclude& step) {
  if (context_.lane.returning()) // what waited for this goes on, and concludes
    return;
  if (question_ && (question_->heard || question_->pending))
    return;
  ask_what_misses(OutputAct::question, step.turn);
  acknowledge_unasked(step.turn);
}

void NextQuestion::take(const steps::AskNext& step) {
  ask_what_misses(step.as, step.turn);
}

void NextQuestion::ask_what_misses(OutputAct as, TurnId turn) {
  auto current = frames_.order().current();
  if (context_.ending.is_wished() || !current || waits_for_user(*current))
    return;
  frames_.refresh(*current);
  if (auto slot = to_ask(*current); slot != script::no_id)
    reprompts_.ask_slot(*current, slot, as, turn);
}

// Whether the topic must not ask: while it waits for a yes, or in a subtask,
// unless that is where the user has begun it.
bool NextQuestion::waits_for_user(TopicId topic) const {
  const bool begun = spoken_of_.topic == topic && spoken_of_.turn == turn_ &&
                     !context_.states.was_pushed_by(topic);
  return (context_.states.pushed() && !begun) ||
         confirmations_.wants_a_yes(topic);
}

// What is in doubt must be settled in any case; what is missing is asked for
// where the topic asks at all.
SlotId NextQuestion::to_ask(TopicId topic) const {
  const auto& definition = context_.topic(topic);
  if (frames_[topic].status != TopicStatus::active)
    return script::no_id;
  if (auto slot = frames_.doubtful(topic); slot != script::no_id)
    return slot;
  return definition.kind == script::TopicKind::task && frames_.may_ask(topic)
             ? frames_.missing(topic)
             : script::no_id;
}

// Only where the robot has said nothing at all since the turn began, and the
// topic still misses something that it will not ask for.
void NextQuestion::acknowledge_unasked(TurnId turn) {
  const auto current = frames_.order().current();
  if (turn == 0 || turn != turn_ || output_.spoken() != said_before_ ||
      !current || frames_.may_ask(*current) || context_.ending.is_wished() ||
      waits_for_user(*current) ||
      frames_[*current].status != TopicStatus::active)
    return;
  const auto slot = frames_.missing(*current);
  if (slot != script::no_id)
    words_.say("acknowledge", *current, script::no_id,
               Map{{"missing", context_.topic(*current).slots[slot].name}},
               turn);
}

} // namespace parlour::dialogue
