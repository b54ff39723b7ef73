#include "script/dialogue/topic_engine/act_delivery.hpp"

#include <memory>
#include <utility>

namespace parlour::dialogue {

// What is asked must be looked at before the topic begins: begin_topic drops
// the question, unless it is a <confirm> of this topic. Without bodies to run,
// the filling event begins at once.
void ActDelivery::give_to_topic(steps::Fill&& step) {
  keep_what_is_asked(step);
  add_to_what_is_there(step);
  StepList steps;
  topic_changes_.begin_topic(step.topic, steps);
  if (steps.empty()) {
    filling_.take(std::move(step));
    return;
  }
  steps.add(std::move(step));
  context_.lane.now(std::move(steps));
}

// "Anything else?" "A coffee." It is one more.
void ActDelivery::add_to_what_is_there(steps::Fill& step) {
  if (!question_ || question_->purpose != Asked::For::more ||
      question_->topic != step.topic)
    return;
  const auto& name = context_.topic(step.topic).slots[question_->slot].name;
  auto act = *step.act;
  for (auto& value : act.slots)
    value.more |= value.slot == name;
  step.act = std::make_shared<const Act>(std::move(act));
}

// A topic of system initiative takes only the slot asked for (engine rule 5.3),
// and mends of what it has; who says more is told. "To Ulm, at three", when it
// has asked where to: the time is dropped, and asked for later. "No, at four"
// is kept if the time has a value.
void ActDelivery::keep_what_is_asked(steps::Fill& step) {
  const auto& topic = context_.topic(step.topic);
  if (topic.initiative != script::Initiative::system)
    return;
  const auto asked = question_.slot_asked_for(step.topic);
  const auto& slots = frames_[step.topic].slots;
  const bool mends =
      step.act->kind == ActKind::correct || step.act->kind == ActKind::deny ||
      confirmations_.wants_a_yes(step.topic); // "yes, but at three"
  auto act = *step.act;
  const auto dropped = std::erase_if(act.slots, [&](const SlotValue& value) {
    const auto slot = topic.slot(value.slot);
    return slot != asked && !(mends && slot != script::no_id &&
                              slots[slot].status != SlotStatus::empty);
  });
  if (dropped > 0)
    words_.say("one_by_one", step.topic, script::no_id, {}, step.turn);
  step.act = std::make_shared<const Act>(std::move(act));
}

} // namespace parlour::dialogue
