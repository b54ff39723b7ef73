// The part of the topic engine for changes of topic: one becomes the current
// one, another is suspended for it (engine rule 5, "Which topic next").
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

namespace {

// What needs such a topic may go on.
bool dealt_with(TopicStatus status) {
  return status == TopicStatus::completed || status == TopicStatus::resting;
}

} // namespace

void TopicEngine::begin_topic(TopicId topic, StepList& steps, bool keep) {
  const auto status = context_.frame(topic).status;
  const bool goes_on = is_completing(topic); // asked about anew, as it is
  leave_enquiry(topic);
  auto left = context_.order.activate(topic);
  if (left && *left != topic)
    suspend(*left, steps);
  // A <confirm> of this topic goes on waiting; another's comes again later.
  if (asked_ &&
      (asked_->purpose != Asked::For::yes_or_no || asked_->topic != topic))
    asked_.reset();
  const bool again = keep && status == TopicStatus::completed;
  const bool ended =
      status == TopicStatus::completed || status == TopicStatus::cancelled;
  if (ended)
    steps.append(end_confirms_of(topic));
  if (ended && !again && !goes_on)
    change(topic, {.kind = FrameChange::Kind::reset});
  if (status == TopicStatus::suspended || (again && !goes_on))
    run_body(context_.topic(topic).resumed, topic, script::no_id, 0, steps);
  else if (status != TopicStatus::active && status != TopicStatus::resting &&
           !goes_on)
    run_body(context_.topic(topic).started, topic, script::no_id, 0, steps);
  if (status != TopicStatus::resting)
    set_status(topic, TopicStatus::active);
  begin_needs(topic, steps);
}

// An enquiry that was not answered yet is not unfinished: it begins anew,
// unless it is left for a topic that it needs.
void TopicEngine::leave_enquiry(TopicId next) {
  auto current = context_.order.current();
  if (current && *current != next && !context_.order.needs(*current, next) &&
      context_.topic(*current).kind == script::TopicKind::enquiry &&
      context_.frame(*current).status == TopicStatus::active)
    change(*current, {.kind = FrameChange::Kind::reset});
}

// `needs`: those topics first, then on with this one (engine rule 5).
void TopicEngine::begin_needs(TopicId topic, StepList& steps) {
  for (const auto& name : context_.topic(topic).needs) {
    auto need = context_.program->topic(name);
    if (need != script::no_id && context_.order.registered(need) &&
        !dealt_with(context_.frame(need).status))
      steps.push_back(topic_step(StepKind::activate, need));
  }
}

void TopicEngine::suspend(TopicId topic, StepList& steps) {
  output_.withdraw_questions();
  set_status(topic, TopicStatus::suspended);
  run_body(context_.topic(topic).suspended, topic, script::no_id, 0, steps);
}

void TopicEngine::activate(Step& step) {
  if (step.topic == script::no_id || !context_.order.registered(step.topic))
    return;
  StepList steps;
  const bool keep = step.mark != 0;
  begin_topic(step.topic, steps, keep);
  auto next = topic_step(StepKind::settle, step.topic);
  next.turn = step.turn;
  if (keep && late_ && late_->topic == context_.topic(step.topic).name) {
    next.kind = StepKind::fill;
    next.act = std::make_shared<const Act>(*std::exchange(late_, {}));
  }
  steps.push_back(std::move(next));
  context_.lane.now(std::move(steps));
}

// A topic whose <confirm> is asked again or answered is the current one.
StepList TopicEngine::back_to(TopicId topic) {
  StepList steps;
  if (topic != script::no_id &&
      context_.frame(topic).status == TopicStatus::suspended)
    begin_topic(topic, steps);
  return steps;
}

} // namespace parlour::dialogue
