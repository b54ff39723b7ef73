#include "script/dialogue/topic_engine/topic_changes.hpp"

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
  if (ended)
    steps.append(confirmations_.end_confirms_of(topic));
  if (ended && !again && !goes_on)
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
