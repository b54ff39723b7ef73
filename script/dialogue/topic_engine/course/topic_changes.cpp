#include "script/dialogue/topic_engine/course/topic_changes.hpp"

#include <memory>

#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/questions/bodies.hpp"

namespace parlour::dialogue {

namespace {

// What needs such a topic may go on.
bool dealt_with(TopicStatus status) {
  return status == TopicStatus::completed || status == TopicStatus::resting;
}

} // namespace

// A correction of a completed topic ("no, at four") comes here by <activate
// keep="true"> in the <repair>. The values are kept, and the act fills the one
// that changes.
void TopicChanges::take(const steps::Activate& step) {
  if (step.topic == script::no_id || !frames_.order().registered(step.topic))
    return;
  StepList steps;
  begin_topic(step.topic, steps, step.keep);
  if (step.keep && late_ && late_->topic == context_.topic(step.topic).name)
    steps.add(
        steps::Fill{step.topic, step.turn,
                    std::make_shared<const Act>(*std::exchange(late_, {}))});
  else
    steps.add(steps::Settle{step.topic, step.turn});
  context_.lane.now(std::move(steps));
}

// The part is emptied first: what it was told the last time is not for this
// slot. The question comes by a step of its own, as no utterance concludes
// here.
void TopicChanges::take(const steps::Part& step) {
  const auto part = context_.topic(step.topic).slots[step.slot].part;
  if (!frames_.order().registered(part))
    return;
  begin_anew(part, step.with);
  StepList steps;
  begin_topic(part, steps);
  steps.add(steps::Settle{part, step.turn});
  steps.add(steps::AskNext{step.turn});
  context_.lane.now(std::move(steps));
}

// Keys that are no slots are nobody's.
void TopicChanges::begin_anew(TopicId topic, const Value& with) {
  frames_.change(topic, {.kind = FrameChange::Kind::reset});
  if (const auto* values = with.if_map())
    for (const auto& [name, value] : values->entries())
      if (const auto slot = context_.topic(topic).slot(name);
          slot != script::no_id && !value.is_unknown())
        frames_.change(
            topic,
            {.kind = FrameChange::Kind::set, .slot = slot, .value = value});
}

// The result is filled like something that the user has said, so the slot's
// <filled> and the constraints follow. It is for certain (confidence 1), as
// each of its values was accepted already.
StepList TopicChanges::back_to_needing(TopicId topic, TopicId completed,
                                       TurnId turn) {
  StepList steps;
  steps.add(steps::Activate{topic, turn});
  if (auto act = result_for(topic, completed))
    steps.add(steps::Fill{topic, turn, std::move(act)});
  return steps;
}

// For the first slot that the part fills and that has no value; null: none.
ActPointer TopicChanges::result_for(TopicId topic, TopicId part) const {
  const auto& slots = context_.topic(topic).slots;
  for (SlotId slot = 0; slot < slots.size(); ++slot) {
    if (slots[slot].part != part ||
        frames_[topic].slots[slot].status != SlotStatus::empty)
      continue;
    SlotValue value;
    value.slot = slots[slot].name;
    value.value = frames_[part].last;
    value.confidence = 1;
    Act act;
    act.topic = context_.topic(topic).name;
    act.confidence = 1;
    act.elliptical = true; // gathered in several turns, not said at once
    act.slots.push_back(std::move(value));
    return std::make_shared<const Act>(std::move(act));
  }
  return nullptr;
}

// Status before and after say which body runs: <started> for a topic that
// begins (untouched, completed, cancelled), <resumed> for one that goes on
// (suspended, or completed with its values kept), none for one that is active
// or rests. A topic whose <completed> still waits goes on as if it were not
// completed: no body runs and no value goes.
//
// The status is read before anything changes it, and the topic that is left is
// suspended before this one's body runs: its <suspended> comes first.
void TopicChanges::begin_topic(TopicId topic, StepList& steps, bool keep) {
  const auto status = frames_[topic].status;
  const bool goes_on =
      confirmations_.is_completing(topic); // asked about anew, as it is
  leave_enquiry(topic);
  auto left = frames_.order().activate(topic);
  if (left && *left != topic)
    suspend(*left, steps);
  // A <confirm> of this topic goes on waiting; another's comes again later.
  if (question_ && (question_->purpose != Asked::For::yes_or_no ||
                    question_->topic != topic))
    question_.reset();
  const bool again = keep && status == TopicStatus::completed;
  const bool ended =
      status == TopicStatus::completed || status == TopicStatus::cancelled;
  // What an ended topic still asks would be about its old values.
  if (ended)
    steps.append(confirmations_.end_confirms_of(topic));
  // What initial values read of other topics may have changed since.
  const bool first = status == TopicStatus::untouched &&
                     !context_.program->read_elsewhere.empty();
  if (first || (ended && !again && !goes_on))
    frames_.change(topic, {.kind = FrameChange::Kind::reset});
  if (status == TopicStatus::suspended || (again && !goes_on))
    run_body(context_.topic(topic).resumed, topic, script::no_id, 0, steps);
  else if (status != TopicStatus::active && status != TopicStatus::resting &&
           !goes_on)
    run_body(context_.topic(topic).started, topic, script::no_id, 0, steps);
  if (status != TopicStatus::resting)
    frames_.set_status(topic, TopicStatus::active);
  begin_needs(topic, steps);
}

// `needs`: those topics first, then on with this one (engine rule 5).
void TopicChanges::begin_needs(TopicId topic, StepList& steps) {
  for (const auto& name : context_.topic(topic).needs) {
    auto need = context_.program->topic(name);
    if (need != script::no_id && frames_.order().registered(need) &&
        !dealt_with(frames_[need].status))
      steps.add(steps::Activate{need});
  }
}

// An enquiry that was not answered yet is not unfinished: it begins anew,
// unless it is left for a topic that it needs.
void TopicChanges::leave_enquiry(TopicId next) {
  auto current = frames_.order().current();
  if (current && *current != next && !frames_.order().needs(*current, next) &&
      context_.topic(*current).kind == script::TopicKind::enquiry &&
      frames_[*current].status == TopicStatus::active)
    frames_.change(*current, {.kind = FrameChange::Kind::reset});
}

void TopicChanges::suspend(TopicId topic, StepList& steps) {
  asking_.withdraw_words();
  frames_.set_status(topic, TopicStatus::suspended);
  run_body(context_.topic(topic).suspended, topic, script::no_id, 0, steps);
}

// A topic whose <confirm> is asked again or answered is the current one.
StepList TopicChanges::back_to(TopicId topic) {
  StepList steps;
  if (topic != script::no_id && frames_[topic].status == TopicStatus::suspended)
    begin_topic(topic, steps);
  return steps;
}

void TopicChanges::take_up(TopicId topic) {
  StepList steps;
  begin_topic(topic, steps);
  steps.add(steps::Settle{topic});
  steps.add(steps::AskNext{.as = OutputAct::resume});
  context_.lane.now(std::move(steps));
}

void TopicChanges::answered(TopicId topic) {
  frames_.answered(topic);
  question_.reset_of(topic);
}

TopicId TopicChanges::needed_by(TopicId topic) const {
  for (auto other : frames_.order().suspended())
    if (frames_.order().needs(other, topic))
      return other;
  return script::no_id;
}

} // namespace parlour::dialogue
